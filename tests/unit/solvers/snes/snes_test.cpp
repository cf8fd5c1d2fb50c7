// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/other_newtons.hpp"

namespace netloft::test {
namespace {

Solved solve_by_snes(Scene scene, Values parameters = {}, Limits limits = {}) {
  return solve_by("snes", std::move(scene), std::move(parameters), limits);
}

TEST(Snes, FindsTheRopeThatNewtonFindsBySearchingLines) {
  const Solved snes = solve_by_snes(rope_near_its_shape());
  expect_same_shape(snes, solve(rope_near_its_shape()));
  EXPECT_EQ(snes.solution.factorisation.find("CHOLMOD"), std::string::npos);  // any definiteness will do
}

TEST(Snes, FindsTheRopeThatNewtonFindsInATrustRegion) {
  const Solved snes = solve_by_snes(rope_near_its_shape(), {{"strategy", std::string("trust-region")}});
  expect_same_shape(snes, solve(rope_near_its_shape()));
}

TEST(Snes, FindsTheRopeThatNewtonFindsByWholeStepsFromSlack) {
  expect_same_shape(solve_by_snes(sample::hanging_rope(40), kWholeSteps), solve(sample::hanging_rope(40)));
}

TEST(Snes, FindsThePanelThatNewtonFinds) {
  const Solved snes = solve_by_snes(sample::hanging_panel(8, 34), kWholeSteps);
  const Solved newton = solve(sample::hanging_panel(8, 34));
  ASSERT_EQ(snes.solution.status, SolveStatus::converged) << snes.solution.reason;
  EXPECT_NEAR(snes.lowest_z(), newton.lowest_z(), 1e-5);
}

TEST(Snes, ReportsEveryAcceptedPoint) {
  const Solution s = solve_by_snes(rope_near_its_shape()).solution;
  ASSERT_EQ(s.history.size(), static_cast<std::size_t>(s.books.iterations) + 1);
  for (std::size_t i = 0; i < s.history.size(); ++i) EXPECT_EQ(s.history[i].iteration, static_cast<int>(i));
  EXPECT_GE(s.books.factorisations, s.books.iterations);
}

TEST(Snes, StopsWhenItIsTold) {
  Limits limits;
  limits.iterations = 3;
  const Solution s = solve_by_snes(sample::hanging_rope(40), kWholeSteps, limits).solution;
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("the limit of 3 iterations was reached"), std::string::npos) << s.reason;
  EXPECT_EQ(s.history.size(), 4u);
}

// Its measure of progress, the sum of squares of the residual, has low points where nothing is in balance.
TEST(Snes, SaysThatNoStepBringsASlackRopeCloser) {
  for (const std::string strategy : {"linesearch", "trust-region"}) {
    const Solution s =
        solve_by_snes(sample::hanging_rope(40), {{"strategy", strategy}, {"damping", 1e-3}}).solution;
    EXPECT_EQ(s.status, SolveStatus::not_converged);
    EXPECT_NE(s.reason.find("no step brings it closer"), std::string::npos) << s.reason;
  }
}

TEST(Snes, HasNothingToDoWhereAllIsHeld) {
  const Solution s = solve_by_snes(sample::hanging_rope(1)).solution;
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_EQ(s.books.factorisations, 0);
}

TEST(Snes, RefusesAStrategyThatItDoesNotHave) {
  try {
    solve_by_snes(sample::hanging_rope(4), {{"strategy", std::string("dogleg")}});
    FAIL() << "not refused";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("strategy"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace netloft::test
