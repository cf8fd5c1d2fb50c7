# SPDX-License-Identifier: BSD-3-Clause
# netloft_test(NAME [ROOMS folders…] [EXCEPT files…] [SOURCES files…] LIBRARIES targets… [OPTIONS flags…] [SLOW_TESTS names…] [SLOW|LONG]):
# one GoogleTest program, each of its tests known to ctest. Its sources are *_test.cpp in ROOMS, compiled as one (NetloftLibrary.cmake),
# and SOURCES, which are compiled as one if there are no ROOMS. OPTIONS are those of the plugin whose kernels are
# among SOURCES. SLOW, or SLOW_TESTS for some tests of a program: they take minutes to compile or run under
# sanitizers, so that .ci/run runs them only without sanitizers; LONG: .ci/run leaves the program to tests/nightly.
#
# With NETLOFT_TEST_PROGRAMS, ctest runs the program as one test, which starts once: for sanitizers, which
# take longer to start than most tests.
#
# netloft_long_tests(NAMES…): some of the tests that take longest, mostly by compiling plugins, starting the
# program or waiting, which .ci/run leaves to tests/nightly. netloft_first_tests(NAMES…): other long tests,
# which start first, so that none of them runs alone at the end.
#
# Tests are hundreds of small sources, whose compile time is mostly that of shared headers, and of optimising
# code that runs once. So these headers are precompiled (except where OPTIONS differ, with which GCC refuses
# them), and tests are optimised little; the code that they test is built as in releases.
include_guard(GLOBAL)
include(GoogleTest)
include(NetloftPrecompile)
add_custom_target(netloft_sanitized)  # what .ci/run builds a second time, with sanitizers
option(NETLOFT_TEST_PROGRAMS "Let ctest know each program of tests, not each test of it" OFF)

function(netloft_test name)
  cmake_parse_arguments(arg "SLOW;LONG" "" "ROOMS;EXCEPT;SOURCES;LIBRARIES;OPTIONS;SLOW_TESTS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  if(arg_ROOMS)
    netloft_sources(${name} ROOMS ${arg_ROOMS} ENDING _test.cpp EXCEPT ${arg_EXCEPT})
  else()
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${NETLOFT_UNITY} UNITY_BUILD_BATCH_SIZE 0)
  endif()
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} netloft_test_folders GTest::gtest GTest::gtest_main)
  if(arg_OPTIONS)
    target_compile_options(${name} PRIVATE ${arg_OPTIONS} $<$<CONFIG:Release>:-O1>)
  else()
    netloft_precompile_programs(${name})
  endif()
  # Threads of OpenMP busy-wait when the cores are occupied. OpenBLAS's kernels for small matrices for
  # Cooperlake allocate at every call; those for Haswell run on every machine with AVX2 and do not. There are
  # two properties, because gtest_discover_tests passes on only one entry of each.
  set(label googletest)
  if(arg_LONG)
    set(label long)
  elseif(arg_SLOW)
    set(label slow)
  else()
    add_dependencies(netloft_sanitized ${name})
  endif()
  if(NETLOFT_TEST_PROGRAMS)
    list(JOIN arg_SLOW_TESTS ":" slow)
    add_test(NAME ${name} COMMAND ${name} "--gtest_filter=-${slow}")
    set_tests_properties(${name} PROPERTIES TIMEOUT 1800 LABELS ${label} ENVIRONMENT "OMP_THREAD_LIMIT=1"
                         ENVIRONMENT_MODIFICATION "OPENBLAS_CORETYPE=set:Haswell")
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_TYPES NO_PRETTY_VALUES PROPERTIES TIMEOUT 300 ENVIRONMENT "OMP_THREAD_LIMIT=1"
                       LABELS ${label} ENVIRONMENT_MODIFICATION "OPENBLAS_CORETYPE=set:Haswell")
endfunction()

function(netloft_first_tests)
  set_property(TEST ${ARGN} PROPERTY COST 1000)
endfunction()

function(netloft_long_tests)
  set_property(TEST ${ARGN} APPEND PROPERTY LABELS long)
  netloft_first_tests(${ARGN})
endfunction()
