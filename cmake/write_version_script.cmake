# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# cmake -DLIST=lib/tyndall.symbols -DMAP=out.map -DNODE=TYNDALL_0 -P write_version_script.cmake
# Turns an export list (one symbol a line, # starts a comment) into a linker version script.
file(STRINGS "${LIST}" lines)
set(body "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "#.*" "" line "${line}")
  string(STRIP "${line}" line)
  if(line)
    string(APPEND body "    ${line};\n")
  endif()
endforeach()
if(body)
  string(PREPEND body "  global:\n")
endif()
file(WRITE "${MAP}" "${NODE} {\n${body}  local:\n    *;\n};\n")
