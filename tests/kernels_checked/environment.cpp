// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// How oclgrind 21.10 has to be run: without optimization. From optimized kernels it gets intrinsics that it does not know
// (llvm.experimental.noalias.scope.decl), and its check for uninitialized values crashes on some vectors.
#include <cstdlib>

namespace {

[[maybe_unused]] const int chosen = setenv("OCLGRIND_BUILD_OPTIONS", "-cl-opt-disable", 0);

} // namespace
