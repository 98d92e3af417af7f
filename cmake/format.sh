#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# format.sh CLANG_FORMAT ARGUMENT...: runs clang-format on every C, C++ and OpenCL file that git does not ignore. Exit
# status 77 where there is no git to ask.
set -eu
cd "$(dirname "$0")/.."
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || {
  echo "not a git checkout: nothing is formatted"
  exit 77
}
git ls-files --cached --others --exclude-standard -z -- \
    '*.c' '*.h' '*.cpp' '*.hpp' '*.cl' '*.clh' ':!:third_party' |
  xargs -0 -r "$@"
