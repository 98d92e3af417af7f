# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# Headers, libraries, package config and pkg-config files. Nothing installed holds an absolute path: the tree may move.
include(CMakePackageConfigHelpers)

set(config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/tyndall")

# The .pc files say where they are relative to themselves.
set(PC_DIR "${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig")
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY "${PC_DIR}" OUTPUT_VARIABLE PC_PREFIX)
string(REGEX REPLACE "/$" "" PC_PREFIX "${PC_PREFIX}")

# tyn_install(TARGET COMPONENT HEADER...): COMPONENT names the export set, the config's targets file and the .pc file.
function(tyn_install target component)
  install(TARGETS ${target} EXPORT ${component}-targets
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(FILES ${ARGN} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tyndall")
  install(EXPORT ${component}-targets NAMESPACE tyndall:: DESTINATION "${config_dir}")
  configure_file("${PROJECT_SOURCE_DIR}/lib/${component}.pc.in" "${PROJECT_BINARY_DIR}/${component}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${component}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endfunction()

set(headers "${PROJECT_SOURCE_DIR}/lib/include/tyndall")
file(GLOB core_headers CONFIGURE_DEPENDS "${headers}/*.h" "${headers}/*.hpp")
list(REMOVE_ITEM core_headers "${headers}/tyndall_io.h")

# A static library hands its dependencies on to whoever links it.
if(NOT BUILD_SHARED_LIBS)
  set(PC_STATIC_REQUIRES "OpenCL")
  set(PC_STATIC_LIBS "-lembree${TYN_EMBREE_MAJOR} -lstdc++ -lpthread")
  set(PC_STATIC_IO_REQUIRES "tinygltf OpenEXR libpng")
  set(PC_STATIC_IO_LIBS "-lmeshoptimizer")
endif()
tyn_install(tyndall tyndall ${core_headers})
if(TARGET tyndall_io)
  tyn_install(tyndall_io tyndall-io "${headers}/tyndall_io.h")
endif()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/tyndallConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/tyndallConfig.cmake"
  INSTALL_DESTINATION "${config_dir}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tyndallConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/tyndallConfig.cmake" "${PROJECT_BINARY_DIR}/tyndallConfigVersion.cmake"
  DESTINATION "${config_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}")
