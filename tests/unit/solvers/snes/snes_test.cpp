// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/other_newtons.hpp"

namespace netloft::test {
namespace {

INSTANTIATE_TEST_SUITE_P(Snes, OtherNewton, testing::Values("snes"),
                         [](const auto& given) { return std::string(given.param); });

const std::string kTrustRegion = "trust-region";

TEST(Snes, FindsTheRopeThatNewtonFindsInATrustRegion) {
  expect_same_shape(solve_by("snes", rope_near_its_shape(), {{"strategy", kTrustRegion}}),
                    solve(rope_near_its_shape()));
}

// For the reason for which no line leads there, either.
TEST(Snes, SaysThatNoTrustRegionBringsASlackRopeCloser) {
  const Solution s =
      solve_by("snes", sample::hanging_rope(40), {{"strategy", kTrustRegion}, {"damping", 1e-3}}).solution;
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("no step brings it closer"), std::string::npos) << s.reason;
}

}  // namespace
}  // namespace netloft::test
