// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/other_newtons.hpp"

namespace netloft::test {
namespace {

Solved solve_by_kinsol(Scene scene, Values parameters = {}, Limits limits = {}) {
  return solve_by("kinsol", std::move(scene), std::move(parameters), limits);
}

TEST(Kinsol, FindsTheRopeThatNewtonFindsBySearchingLines) {
  const Solved kinsol = solve_by_kinsol(rope_near_its_shape());
  expect_same_shape(kinsol, solve(rope_near_its_shape()));
  EXPECT_EQ(kinsol.solution.factorisation.find("CHOLMOD"), std::string::npos);  // any definiteness will do
}

TEST(Kinsol, FindsTheRopeThatNewtonFindsByWholeStepsFromSlack) {
  expect_same_shape(solve_by_kinsol(sample::hanging_rope(40), kWholeSteps), solve(sample::hanging_rope(40)));
}

TEST(Kinsol, FindsThePanelThatNewtonFinds) {
  const Solved kinsol = solve_by_kinsol(sample::hanging_panel(8, 34), kWholeSteps);
  const Solved newton = solve(sample::hanging_panel(8, 34));
  ASSERT_EQ(kinsol.solution.status, SolveStatus::converged) << kinsol.solution.reason;
  EXPECT_NEAR(kinsol.lowest_z(), newton.lowest_z(), 1e-5);
}

TEST(Kinsol, ReportsEveryAcceptedPoint) {
  const Solution s = solve_by_kinsol(rope_near_its_shape()).solution;
  ASSERT_EQ(s.history.size(), static_cast<std::size_t>(s.books.iterations) + 1);
  for (std::size_t i = 0; i < s.history.size(); ++i) EXPECT_EQ(s.history[i].iteration, static_cast<int>(i));
  EXPECT_EQ(s.books.factorisations, s.books.iterations);
}

TEST(Kinsol, StopsWhenItIsTold) {
  Limits limits;
  limits.iterations = 3;
  const Solution s = solve_by_kinsol(sample::hanging_rope(40), kWholeSteps, limits).solution;
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("the limit of 3 iterations was reached"), std::string::npos) << s.reason;
  EXPECT_EQ(s.history.size(), 4u);
}

// Its measure of progress, the sum of squares of the residual, has low points where nothing is in balance.
TEST(Kinsol, SaysThatNoStepBringsASlackRopeCloser) {
  const Solution s = solve_by_kinsol(sample::hanging_rope(40)).solution;
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("no step brings it closer"), std::string::npos) << s.reason;
}

TEST(Kinsol, HasNothingToDoWhereAllIsHeld) {
  const Solution s = solve_by_kinsol(sample::hanging_rope(1)).solution;
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_EQ(s.books.factorisations, 0);
}

TEST(Kinsol, RefusesAStrategyThatItDoesNotHave) {
  try {
    solve_by_kinsol(sample::hanging_rope(4), {{"strategy", std::string("picard")}});
    FAIL() << "not refused";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("strategy"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace netloft::test
