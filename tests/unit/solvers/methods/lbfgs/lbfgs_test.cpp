// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/ways_to_known_answers.hpp"

namespace netloft::test {
namespace {

constexpr Way kWays[] = {
    {"Stiffness", "lbfgs", "preconditioner", "stiffness"},
    {"Diagonal", "lbfgs", "preconditioner", "diagonal", "runs away"},
    {"None", "lbfgs", "preconditioner", "none", "runs away"},
};
INSTANTIATE_TEST_SUITE_P(LbfgsPreconditionedBy, KnownAnswers, testing::ValuesIn(kWays), name_of);

Values preconditioned_by(const std::string& word) { return {{"preconditioner", word}}; }

TEST(Lbfgs, FactorisesTheLinearStiffnessOnceAndNothingElse) {
  const Solved s = solve_with("lbfgs", sample::hanging_panel(8, 34));
  EXPECT_EQ(s.solution.cost.statistics.factorisations, 1);
  EXPECT_EQ(s.solution.cost.statistics.matrices, 0);
  const Solved diagonal = solve_with("lbfgs", sample::hanging_panel(8, 34), preconditioned_by("diagonal"));
  EXPECT_EQ(diagonal.solution.cost.statistics.factorisations, 0);
}

TEST(Lbfgs, TakesFewerStepsWithTheLinearStiffness) {
  const auto residuals = [](const char* word) {
    return solve_with("lbfgs", sample::hanging_panel(8, 34), preconditioned_by(word))
        .solution.cost.statistics.residuals;
  };
  EXPECT_LT(2 * residuals("stiffness"), residuals("none"));
}

TEST(Lbfgs, RefusesForcesWithoutAnEnergy) {
  const Solved s = solve_with("lbfgs", pushed_bar(5));
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "lbfgs needs a problem that is conservative")) << s.solution.reason;
}

TEST(Lbfgs, StopsWhenToleranceIsBelowRoundOff) {
  Limits limits;
  limits.tolerance = 1e-300;
  const Solved s = solve_with("lbfgs", sample::hanging_rope(20), {}, limits);
  EXPECT_LT(s.solution.balance.residual, 1e-9 * s.solution.balance.scale);
}

}  // namespace
}  // namespace netloft::test
