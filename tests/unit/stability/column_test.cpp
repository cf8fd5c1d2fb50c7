// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/column.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace netloft::hard_cases {
namespace {

using Words = std::vector<std::string>;

TEST(HardCaseColumn, IsASolverAlone) {
  EXPECT_EQ(column_of("newton:damping=1").solver, "newton:damping=1");
  EXPECT_EQ(column_of("newton:damping=1").strategy, "");
}

TEST(HardCaseColumn, IsNamedAfterWhatItRuns) {
  EXPECT_EQ((Column{"newton", ""}.head()), "newton");
  EXPECT_EQ((Column{"", "auto"}.head()), "auto");
  EXPECT_EQ((Column{"ptc", "load-steps"}.head()), "load-steps with ptc");
  EXPECT_EQ((Column{.solver = "ptc", .strategy = "", .title = "pseudo-time"}.head()), "pseudo-time");
}

TEST(HardCaseColumn, SetsTheAnalysisOfAScene) {
  EXPECT_EQ(overrides_of({"newton:method=classic", ""}),
            (Words{"analysis.solver=\"newton\"", "analysis.newton.method=classic"}));
  EXPECT_EQ(overrides_of({"ptc", "tension/stages:ratio=4"}),
            (Words{"analysis.solver=\"ptc\"", "analysis.strategy=\"tension/stages\"",
                   "analysis.tension.stages.ratio=4"}));
  EXPECT_EQ(overrides_of({"ptc", "", {"analysis.max_iterations=7"}}),
            (Words{"analysis.max_iterations=7", "analysis.solver=\"ptc\""}));
  EXPECT_EQ(overrides_of({"", "direct", {"analysis.strategy=auto"}}).back(), "analysis.strategy=\"direct\"")
      << "what it is called it is";
}

TEST(HardCaseColumn, PartsAreLeftOutOfAutoAlone) {
  Column plain{"", "auto"}, tuned{"", "auto:restarts=2"}, other{"", "direct"}, solver{"newton", ""};
  for (auto* column : {&plain, &tuned, &other, &solver}) leave_out({"restarts", "tension-stages"}, *column);
  EXPECT_EQ(plain.strategy, "auto:without=restarts+tension-stages");
  EXPECT_EQ(tuned.strategy, "auto:restarts=2,without=restarts+tension-stages");
  EXPECT_EQ(other.strategy, "direct");
  EXPECT_EQ(solver.strategy, "");
  EXPECT_EQ(overrides_of(plain),
            (Words{"analysis.strategy=\"auto\"", "analysis.auto.without=restarts+tension-stages"}));
}

TEST(HardCaseColumn, LeavesOutWhatItLeavesOutItselfToo) {
  Column own{"", "auto:without=direct"}, amid{"", "auto:slice=3,without=direct,restarts=1"};
  for (auto* column : {&own, &amid}) leave_out({"restarts"}, *column);
  EXPECT_EQ(own.strategy, "auto:without=restarts+direct");
  EXPECT_EQ(amid.strategy, "auto:slice=3,without=restarts+direct,restarts=1");
}

TEST(HardCaseColumn, ASpecificationThatIsNotUnderstoodIsRefused) {
  EXPECT_THROW(overrides_of({"newton:", ""}), std::invalid_argument);
  EXPECT_THROW(overrides_of({"", "load steps"}), std::invalid_argument);
  EXPECT_THROW(overrides_of({"", "auto:restarts=1,slice=3,restarts=2"}), std::invalid_argument);
}

}  // namespace
}  // namespace netloft::hard_cases
