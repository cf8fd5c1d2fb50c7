// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/other_newtons.hpp"

namespace netloft::test {
namespace {

INSTANTIATE_TEST_SUITE_P(Kinsol, OtherNewton, testing::Values("kinsol"),
                         [](const auto& given) { return std::string(given.param); });

TEST(Kinsol, FactorisesOnceAnIteration) {
  const Solution s = solve_by("kinsol", rope_near_its_shape()).solution;
  EXPECT_GT(s.cost.statistics.iterations, 0);
  EXPECT_EQ(s.cost.statistics.factorisations, s.cost.statistics.iterations);
}

}  // namespace
}  // namespace netloft::test
