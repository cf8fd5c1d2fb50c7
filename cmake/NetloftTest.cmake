# SPDX-License-Identifier: BSD-3-Clause
# netloft_test(NAME SOURCES files… LIBRARIES targets… [OPTIONS flags…]): one GoogleTest program, each of its tests known to
# ctest. OPTIONS are those of the plugin whose kernels stand among SOURCES.
#
# Tests are hundreds of small sources, whose time of compiling is mostly that of the headers they share, and of optimising
# what runs once. So these headers are compiled once (not where OPTIONS differ: GCC would not take them), and tests are
# optimised little; what they test is built as people build it.
include_guard(GLOBAL)
include(GoogleTest)
include(NetloftPrecompile)

function(netloft_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES;OPTIONS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
  if(arg_OPTIONS)
    target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  else()
    netloft_precompile_programs(${name})
  endif()
  # CHOLMOD opens OpenMP regions that spin when the cores are taken. Of OpenBLAS's kernels for small matrices those for
  # Cooperlake allocate at every call; those for Haswell run on every machine with AVX2 and do not. Two properties, because
  # gtest_discover_tests hands on one entry of each.
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_TYPES NO_PRETTY_VALUES PROPERTIES TIMEOUT 300 ENVIRONMENT "OMP_THREAD_LIMIT=1"
                       ENVIRONMENT_MODIFICATION "OPENBLAS_CORETYPE=set:Haswell")
endfunction()
