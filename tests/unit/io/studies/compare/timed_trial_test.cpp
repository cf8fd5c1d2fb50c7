// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/timed_trial.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <set>

namespace netloft::studies {
namespace {

runs::CaseSource pendulum(std::vector<std::string> more) {
  more.push_back("analysis.duration=1");
  return {test::source_folder() + "/gear-library/scenes/dynamics/elastic-pendulum.toml", std::move(more), 1};
}

TEST(TrialInTime, ReportsEveryStepUnderTheNameOfItsRun) {
  std::int64_t steps = 0;
  std::set<std::string> names;
  runs::Watch watch;
  watch.on_step = [&](const StepRecord& step, const std::string& run) {
    steps = step.steps;
    names.insert(run);
  };
  const Trial t = run_trial(pendulum({}), test::shipped_plugins(), {"integrator newmark"}, 1e-2, 1, watch);
  EXPECT_EQ(t.of_motion, "finished");
  EXPECT_EQ(steps, t.steps);
  EXPECT_EQ(names, std::set<std::string>{"newmark at 1e-02"});
}

TEST(TrialInTime, EndsWithItsBudgetOfWorkAndSaysWhere) {
  const Trial whole = run_trial(pendulum({}), test::shipped_plugins(), {"integrator newmark"}, 1e-3, 1, {});
  const Trial part = run_trial(pendulum({"analysis.work=1e-3"}), test::shipped_plugins(),
                               {"integrator newmark"}, 1e-3, 1, {});
  EXPECT_EQ(part.of_motion, "out of work");
  EXPECT_FALSE(part.converged());
  EXPECT_LT(part.statistics.iterations, whole.statistics.iterations);
  EXPECT_LT(part.steps, whole.steps);
  EXPECT_TRUE(part.reason.starts_with("the budget of work was spent at t = 0.")) << part.reason;
}

}  // namespace
}  // namespace netloft::studies
