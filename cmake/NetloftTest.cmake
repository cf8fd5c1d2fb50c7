# SPDX-License-Identifier: BSD-3-Clause
# netloft_test(NAME SOURCES files… LIBRARIES targets…): one GoogleTest program, each of its tests known to ctest.
include_guard(GLOBAL)
include(GoogleTest)

function(netloft_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE NETLOFT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             NETLOFT_BINARY_DIR="${PROJECT_BINARY_DIR}")
  # CHOLMOD opens OpenMP regions that spin when the cores are taken. Of OpenBLAS's kernels for small matrices those for
  # Cooperlake allocate at every call; those for Haswell run on every machine with AVX2 and do not. Two properties, because
  # gtest_discover_tests hands on one entry of each.
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_TYPES NO_PRETTY_VALUES PROPERTIES TIMEOUT 300 ENVIRONMENT "OMP_THREAD_LIMIT=1"
                       ENVIRONMENT_MODIFICATION "OPENBLAS_CORETYPE=set:Haswell")
endfunction()
