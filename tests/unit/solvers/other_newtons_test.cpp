// SPDX-License-Identifier: BSD-3-Clause
//
// Results that Newton's methods of other libraries must have. The test of each solver is built with this
// file.
#include "tests/unit/solvers/other_newtons.hpp"

namespace netloft::test {
namespace {

TEST_P(OtherNewton, FindsTheRopeThatOursFindsBySearchingLines) {
  const Solved other = solve_by_it(rope_near_its_shape());
  expect_same_shape(other, solve(rope_near_its_shape()));
  EXPECT_EQ(other.solution.run.factorisation.find("multifrontal"), std::string::npos);  // K may be indefinite
}

TEST_P(OtherNewton, FindsTheRopeThatOursFindsByWholeStepsFromSlack) {
  expect_same_shape(solve_by_it(sample::hanging_rope(40), kWholeSteps), solve(sample::hanging_rope(40)));
}

TEST_P(OtherNewton, FindsThePanelThatOursFinds) {
  const Solved other = solve_by_it(sample::hanging_panel(8, 34), kWholeSteps);
  const Solved ours = solve(sample::hanging_panel(8, 34));
  ASSERT_EQ(other.solution.status, SolveStatus::converged) << other.solution.reason;
  EXPECT_NEAR(other.lowest_z(), ours.lowest_z(), 1e-5);
}

TEST_P(OtherNewton, ReportsEveryAcceptedPoint) {
  const Solution s = solve_by_it(rope_near_its_shape()).solution;
  ASSERT_EQ(s.run.history.size(), static_cast<std::size_t>(s.cost.statistics.iterations) + 1);
  for (std::size_t i = 0; i < s.run.history.size(); ++i)
    EXPECT_EQ(s.run.history[i].iteration, static_cast<int>(i));
  EXPECT_GE(s.cost.statistics.factorisations, s.cost.statistics.iterations);
}

TEST_P(OtherNewton, StopsWhenItIsTold) {
  Limits limits;
  limits.iterations = 3;
  const Solution s = solve_by_it(sample::hanging_rope(40), kWholeSteps, limits).solution;
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("the limit of 3 iterations was reached"), std::string::npos) << s.reason;
  EXPECT_EQ(s.run.history.size(), 4u);
}

// The method minimises the sum of squares of the residual, which has minima that are not equilibria.
TEST_P(OtherNewton, SaysThatNoStepBringsASlackRopeCloser) {
  for (const double damping : {0.0, 1e-3}) {
    const Solution s = solve_by_it(sample::hanging_rope(40), {{"damping", damping}}).solution;
    EXPECT_EQ(s.status, SolveStatus::not_converged);
    EXPECT_NE(s.reason.find("no step brings the gear closer"), std::string::npos)
        << damping << ": " << s.reason;
  }
}

TEST_P(OtherNewton, HasNothingToDoWhereAllIsHeld) {
  const Solution s = solve_by_it(sample::hanging_rope(1)).solution;
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_EQ(s.cost.statistics.factorisations, 0);
}

TEST_P(OtherNewton, RefusesAStrategyThatItDoesNotHave) {
  for (const std::string strategy : {"picard", "dogleg"}) {
    try {
      solve_by_it(sample::hanging_rope(4), {{"strategy", strategy}});
      ADD_FAILURE() << strategy << " not refused";
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("strategy"), std::string::npos) << e.what();
    }
  }
}

}  // namespace
}  // namespace netloft::test
