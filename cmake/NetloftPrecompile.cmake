# SPDX-License-Identifier: BSD-3-Clause
# Headers compiled once for many sources: most sources take longer to read the standard library than for
# anything else.
#
# netloft_precompile_programs(TARGET): a program of the tests uses precompiled standard headers and those of
# GoogleTest. netloft_precompile_libraries(FOLDER): all static libraries in a folder and its subfolders use
# precompiled standard headers.
#
# A separate target compiles them, because the others must have its flags, and because a compiler cache serves
# other checkouts only if no path stands in these flags.
#
# A source that lacks an include compiles all the same, so default builds do not precompile: for products,
# NETLOFT_PRECOMPILE is off except in presets for fast builds, and nightly builds set
# CMAKE_DISABLE_PRECOMPILE_HEADERS for tests, too.
include_guard(GLOBAL)

set(netloft_standard_headers
  <algorithm> <array> <cmath> <cstdint> <cstdio> <cstring> <filesystem> <functional> <limits> <map> <memory> <numeric>
  <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>)
set(netloft_no_source ${PROJECT_BINARY_DIR}/headers.cpp)
file(CONFIGURE OUTPUT ${netloft_no_source} CONTENT "int main() {}\n")

function(netloft_precompile_flags target)
  # ccache wants both.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                         "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

function(netloft_precompile_programs target)
  if(NOT TARGET netloft_headers_of_tests)
    add_executable(netloft_headers_of_tests ${netloft_no_source})
    target_link_libraries(netloft_headers_of_tests PRIVATE netloft_root GTest::gtest)
    target_compile_options(netloft_headers_of_tests PRIVATE $<$<CONFIG:Release>:-O1>)
    target_precompile_headers(netloft_headers_of_tests PRIVATE ${netloft_standard_headers} <gtest/gtest.h>)
    netloft_precompile_flags(netloft_headers_of_tests)
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_precompile_headers(${target} REUSE_FROM netloft_headers_of_tests)
  netloft_precompile_flags(${target})
endfunction()

function(netloft_precompile_library target)
  if(NOT TARGET netloft_headers_of_libraries)
    add_library(netloft_headers_of_libraries STATIC ${netloft_no_source})
    target_link_libraries(netloft_headers_of_libraries PRIVATE netloft_root)
    target_precompile_headers(netloft_headers_of_libraries PRIVATE ${netloft_standard_headers})
    netloft_precompile_flags(netloft_headers_of_libraries)
  endif()
  target_precompile_headers(${target} REUSE_FROM netloft_headers_of_libraries)
  netloft_precompile_flags(${target})
endfunction()

function(netloft_precompile_libraries folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      netloft_precompile_library(${target})
    endif()
  endforeach()
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(one IN LISTS below)
    netloft_precompile_libraries(${one})
  endforeach()
endfunction()
