# SPDX-License-Identifier: BSD-3-Clause
# bench_factorisation: orderings and factorisations against each other on nets of 10³, 10⁴, 10⁵ unknowns.
add_executable(bench_factorisation ${CMAKE_CURRENT_LIST_DIR}/factorisation.cpp ../support/sample_scenes.cpp)
target_link_libraries(bench_factorisation PRIVATE netloft_framework netloft_factorisation netloft_net_matrix netloft_test_folders)
