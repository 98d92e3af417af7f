# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# cmake --build BUILD --target format: every C, C++ and OpenCL file in the project's one style.
find_program(CLANG_FORMAT NAMES clang-format-14 clang-format)
if(CLANG_FORMAT)
  add_custom_target(format
    COMMAND sh "${PROJECT_SOURCE_DIR}/cmake/format.sh" "${CLANG_FORMAT}" -i
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    VERBATIM)
endif()
