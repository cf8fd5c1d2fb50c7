# SPDX-License-Identifier: BSD-3-Clause
# bench_factorisation: orderings and factorisations against each other on nets of 10³, 10⁴, 10⁵ unknowns.
# bench_ranks: one of them on several processes; ranks.py starts it.
foreach(name factorisation ranks)
  add_executable(bench_${name} ${CMAKE_CURRENT_LIST_DIR}/${name}.cpp ${CMAKE_CURRENT_LIST_DIR}/panel_tangent.cpp
                 ../support/sample_scenes.cpp)
  target_link_libraries(bench_${name} PRIVATE netloft_framework netloft_factorisation netloft_net_matrix
                                              netloft_test_folders)
endforeach()
