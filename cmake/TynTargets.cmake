# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# Settings that every target of this project shares. They go on targets, never on the directory, so that a project that
# adds Tyndall with add_subdirectory keeps its own flags.

# tyn_defaults(TARGET): language level, warnings, floating-point contract, sanitizers, coverage.
function(tyn_defaults target)
  target_compile_features(${target} PRIVATE c_std_11 cxx_std_17)
  set_target_properties(${target} PROPERTIES
    C_EXTENSIONS OFF CXX_EXTENSIONS OFF
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    POSITION_INDEPENDENT_CODE ON)
  # Kernel maths is also compiled for the host: without fused multiply-adds both sides round alike.
  target_compile_options(${target} PRIVATE
    -ffp-contract=off
    -Wall -Wextra -Wpedantic
    $<IF:$<C_COMPILER_ID:GNU>,-Wshadow=local,-Wshadow> # GCC's plain -Wshadow also means a constructor's parameters
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>
    $<$<BOOL:${TYN_WERROR}>:-Werror>)
  if(TYN_SANITIZE)
    # The instrumentation makes GCC see uninitialized reads in its own std::regex.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized
      -fsanitize=${TYN_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${TYN_SANITIZE})
  endif()
  if(TYN_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage)
    target_link_options(${target} PRIVATE --coverage)
  endif()
endfunction()

# tyn_exports(TARGET LIST): of all symbols of the library, exactly those named in LIST, one a line, are visible.
function(tyn_exports target list)
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "SHARED_LIBRARY")
    return()
  endif()
  set(map "${CMAKE_CURRENT_BINARY_DIR}/${target}.map")
  add_custom_command(
    OUTPUT "${map}"
    COMMAND "${CMAKE_COMMAND}" -DLIST=${list} -DMAP=${map} -DNODE=TYNDALL_${PROJECT_VERSION_MAJOR}
            -P "${PROJECT_SOURCE_DIR}/cmake/write_version_script.cmake"
    DEPENDS "${list}" "${PROJECT_SOURCE_DIR}/cmake/write_version_script.cmake"
    VERBATIM)
  add_custom_target(${target}_map DEPENDS "${map}")
  add_dependencies(${target} ${target}_map)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${map}")
  target_link_options(${target} PRIVATE "LINKER:--version-script=${map}")
endfunction()
