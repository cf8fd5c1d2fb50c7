# SPDX-License-Identifier: BSD-3-Clause
# bench_factorisation: orderings and factorisations against each other on nets of 10³, 10⁴, 10⁵ unknowns.
add_executable(bench_factorisation ${CMAKE_CURRENT_LIST_DIR}/factorisation.cpp ${CMAKE_CURRENT_LIST_DIR}/cholmod_factorisation.cpp ../support/sample_scenes.cpp)
target_link_libraries(bench_factorisation PRIVATE netloft_framework netloft_factorisation netloft_net_matrix netloft_test_folders)
find_path(NETLOFT_CHOLMOD_HEADERS cholmod.h PATH_SUFFIXES suitesparse)
find_library(NETLOFT_CHOLMOD cholmod)
if(NETLOFT_CHOLMOD_HEADERS AND NETLOFT_CHOLMOD)  # only to compare with, in this bench, which nobody passes on
  set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/cholmod_factorisation.cpp PROPERTIES COMPILE_DEFINITIONS NETLOFT_BENCH_CHOLMOD)
  target_include_directories(bench_factorisation SYSTEM PRIVATE ${NETLOFT_CHOLMOD_HEADERS})
  target_link_libraries(bench_factorisation PRIVATE ${NETLOFT_CHOLMOD})
endif()
