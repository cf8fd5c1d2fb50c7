# SPDX-License-Identifier: BSD-3-Clause
# netloft_test(NAME [ROOMS folders…] [EXCEPT files…] [SOURCES files…] LIBRARIES targets… [OPTIONS flags…] [SLOW_TESTS names…] [SLOW|LONG]):
# one GoogleTest program, each of its tests known to ctest. Its sources are *_test.cpp in ROOMS, compiled as one (NetloftLibrary.cmake),
# and SOURCES. OPTIONS are those of the plugin whose kernels stand among SOURCES. SLOW, and the SLOW_TESTS of one that is not: minutes
# to compile or to run under sanitizers, so that .ci/run tries them without them alone; LONG: .ci/run leaves it to tests/nightly.
#
# With NETLOFT_TEST_PROGRAMS ctest knows the program as one test instead, which starts once: for sanitizers, which take
# longer to start than most tests.
#
# netloft_long_tests(NAMES…): a choice of those that take longest, most of it compiling plugins, starting the program or
# waiting, which .ci/run leaves to tests/nightly. netloft_first_tests(NAMES…): others that take long, which are begun first,
# so that none ends alone.
#
# Tests are hundreds of small sources, whose time of compiling is mostly that of the headers they share, and of optimising
# what runs once. So these headers are compiled once (not where OPTIONS differ: GCC would not take them), and tests are
# optimised little; what they test is built as people build it.
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
  endif()
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} netloft_test_folders GTest::gtest GTest::gtest_main)
  if(arg_OPTIONS)
    target_compile_options(${name} PRIVATE ${arg_OPTIONS} $<$<CONFIG:Release>:-O1>)
  else()
    netloft_precompile_programs(${name})
  endif()
  # Threads of OpenMP spin when the cores are taken. Of OpenBLAS's kernels for small matrices those for
  # Cooperlake allocate at every call; those for Haswell run on every machine with AVX2 and do not. Two properties, because
  # gtest_discover_tests hands on one entry of each.
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
