# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# Everything this project links. Each find is here and nowhere else.

find_package(OpenCL REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 CONFIG REQUIRED) # linear algebra of the exact slab solver; headers only

# Embree builds the acceleration structure. Version 4 has the same builder as 3 under another include folder.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.13 CONFIG QUIET)
endif()
if(NOT embree_FOUND)
  message(FATAL_ERROR "Embree 3.13 or newer was not found (Debian and Ubuntu: libembree-dev)")
endif()
string(REGEX MATCH "^[0-9]+" TYN_EMBREE_MAJOR "${embree_VERSION}")
message(STATUS "Embree ${embree_VERSION}")

if(TYN_BUILD_IO)
  find_package(TinyGLTF CONFIG REQUIRED)
  # Through pkg-config: Debian 12's CMake files of Imath name a Python library that libopenexr-dev does not bring along.
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR>=3)
  find_package(PNG REQUIRED)
  find_package(meshoptimizer CONFIG REQUIRED)
endif()

if(TYN_BUILD_IO OR TYN_BUILD_SAMPLES)
  find_package(nlohmann_json 3 CONFIG REQUIRED)
endif()

if(TYN_BUILD_SAMPLES)
  find_package(CLI11 CONFIG REQUIRED)
  # Cairo draws plots; without it the tools do everything else. A wheel, which would have to bring it along with its fonts
  # and X11, has matplotlib for them.
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND AND NOT TYN_BUILD_PYTHON)
    pkg_check_modules(Cairo QUIET IMPORTED_TARGET cairo>=1.14)
  endif()
endif()

if(TYN_BUILD_TESTS)
  find_package(GTest QUIET)
  find_package(Python3 QUIET COMPONENTS Interpreter)
  find_path(RANDOM123_INCLUDE_DIR Random123/philox.h)
  if(NOT GTest_FOUND OR NOT Python3_FOUND OR NOT RANDOM123_INCLUDE_DIR)
    message(FATAL_ERROR "The tests need GoogleTest, Random123 and Python (Debian and Ubuntu: libgtest-dev librandom123-dev "
      "python3). To build without them: -DTYN_BUILD_TESTS=OFF")
  endif()
  find_package(benchmark CONFIG QUIET)
endif()
