# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes an installed wheel self-contained: copies what the libraries in tyndall/_lib need of the system into that folder.
# Copies have names of their own, with a checksum, so that they never stand in for another package's library of the same
# name in one process, nor that one for them. What every Linux has is not copied; nor is the C++ runtime, of which a
# process must not have two (a driver's compiler would get the wrong one), nor the OpenCL loader, which knows the
# system's drivers.
set(folder "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/tyndall/_lib")
file(GLOB libraries "${folder}/libtyndall*.so.*")

function(patchelf)
  execute_process(COMMAND "${TYN_PATCHELF}" ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GET_RUNTIME_DEPENDENCIES
  LIBRARIES ${libraries}
  RESOLVED_DEPENDENCIES_VAR found
  UNRESOLVED_DEPENDENCIES_VAR missing
  PRE_EXCLUDE_REGEXES "^libtyndall" "^ld-linux" "^lib(c|m|dl|rt|pthread|z|gcc_s|stdc\\+\\+|OpenCL)\\.so")
if(missing)
  message(FATAL_ERROR "Not found, though linked: ${missing}")
endif()

set(renaming "")
set(copies "")
foreach(path IN LISTS found)
  get_filename_component(name "${path}" NAME)
  file(REAL_PATH "${path}" file)
  file(SHA256 "${file}" sum)
  string(SUBSTRING "${sum}" 0 8 sum)
  string(REGEX MATCH "^([^.]+)(.*)$" own "${name}")
  set(own "${CMAKE_MATCH_1}-${sum}${CMAKE_MATCH_2}")
  file(COPY_FILE "${file}" "${folder}/${own}")
  file(CHMOD "${folder}/${own}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  patchelf(--set-soname "${own}" --set-rpath "$ORIGIN" "${folder}/${own}")
  list(APPEND renaming --replace-needed "${name}" "${own}")
  list(APPEND copies "${folder}/${own}")
endforeach()
if(copies)
  patchelf(${renaming} ${libraries} ${copies})
endif()

# The licences of what was copied, where the distribution keeps them.
find_program(DPKG_QUERY dpkg-query)
if(NOT DPKG_QUERY)
  message(WARNING "The licences of what was copied from the system are not in the wheel: only dpkg is asked for them")
endif()
foreach(path IN LISTS found)
  if(DPKG_QUERY)
    file(REAL_PATH "${path}" file)
    execute_process(COMMAND "${DPKG_QUERY}" -S "${file}" OUTPUT_VARIABLE owner ERROR_QUIET)
    if(NOT owner) # /lib may be a link to /usr/lib that the package does not know of
      string(REGEX REPLACE "^/usr" "" file "${file}")
      execute_process(COMMAND "${DPKG_QUERY}" -S "${file}" OUTPUT_VARIABLE owner ERROR_QUIET)
    endif()
    string(REGEX REPLACE ":.*" "" owner "${owner}")
    if(owner AND EXISTS "/usr/share/doc/${owner}/copyright")
      file(COPY_FILE "/usr/share/doc/${owner}/copyright" "${folder}/${owner}.copyright.txt")
    endif()
  endif()
endforeach()
