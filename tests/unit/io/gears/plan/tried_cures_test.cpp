// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/tried_cures.hpp"

#include "tests/unit/io/gears/plan/plans.hpp"

namespace netloft::gears {
namespace {

/// The hint of the first message that contains some words; an empty text if there is none.
std::string hint_of(const CheckedPlan& checked, const std::string& words) {
  for (const auto& message : checked.diagnostics.sorted())
    if (message.message.find(words) != std::string::npos) return message.hint;
  return {};
}

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << "not in the plan: " << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}

TEST(TriedCures, AWrongAftCountIsCorrected) {
  const auto checked = check_text(changed_plan("aft = 20\n", "aft = 22\n"));
  EXPECT_EQ(hint_of(checked, "body.aft: the cuttings give 20 meshes, but the plan says 22"),
            "panels.body.aft = 20, or panels.body.fore[0].meshes = 22, or panels.body.fore[1].meshes = 31");
}

/// Each side must cut 25 meshes instead of 30. At 5B1P, this takes a depth of 35 meshes: the whole side, or
/// what 7 straight meshes leave of its 42. The aft count of 20 is not proposed, because the bag that is sewn
/// to it has 30.
TEST(TriedCures, ACutThatIsAWholeSideGetsAnotherDepthOrAStraightRun) {
  const std::string text = replaced(changed_plan("aft = 20\n", "aft = 30\n"), "fore = 20\n", "fore = 30\n");
  EXPECT_EQ(hint_of(check_text(text), "body.aft: the cuttings give 20 meshes"),
            "panels.body.fore[0].meshes = 30, or panels.body.depth = 35, or panels.body.sides = [{cut = "
            "\"AN\", depth = 7}, {cut = \"5B1P in\"}]");
}

TEST(TriedCures, AWrongRateIsReplacedByAUsualOne) {
  const auto checked = check_text(replaced(library_text("four-panel.toml"), "\"1N1B in\"", "\"3N1B in\""));
  EXPECT_TRUE(hint_of(checked, "side.aft").starts_with("panels.side.outer = \"1N1B in\"")) << checked.said();
}

TEST(TriedCures, RatesAreSpelledAsThoseOfThePlan) {
  const auto checked = check_text(changed_plan("sides = \"5B1P in\"", "sides = \"5B1P out\""));
  EXPECT_TRUE(hint_of(checked, "body.aft").starts_with("panels.body.sides = \"5B1P in\"")) << checked.said();
}

TEST(TriedCures, ThePanelIsToldForItsRope) {
  const auto checked = check_text(replaced(library_text("four-panel.toml"), "fore = 60\n", "fore = 75\n"));
  EXPECT_EQ(hint_of(checked, "breast-line is 3.6 m long").substr(0, 21), "panels.side.fore = 60")
      << checked.said();
}

/// With this depth of the cut, the panel becomes more than a mesh narrower, so its aft count must change,
/// too.
TEST(TriedCures, ValuesThatNeedOthersAreToldWithThem) {
  const auto checked =
      check_text(replaced(library_text("83-112-eastern.toml"), "depth = 70 }", "depth = 74 }"));
  EXPECT_TRUE(hint_of(checked, "top-wing.outer: its cuttings go")
                  .starts_with("panels.top-wing.outer[1].depth = 69.7, and then panels.top-wing.aft = 130"))
      << checked.said();
}

TEST(TriedCures, WhatIsStillWrongIsToldIfNothingMore) {
  std::string text =
      changed_plan("[ropes.headline]\nstands = \"middle\"", "[ropes.headline]\nstands = \"alone\"");
  text = replaced(text, "headline.end\"]", "headline.start\"]");
  const std::string hint = hint_of(check_text(text), "wing.inner exists to port and to starboard");
  EXPECT_NE(hint.find(", but then: "), std::string::npos) << hint;
}

TEST(TriedCures, ValuesForAProgramAreThoseOfTheHint) {
  const auto checked = check_text(changed_plan("length = \"6 m\"", "length = \"4 m\""));
  ASSERT_EQ(checked.diagnostics.sorted().size(), 1u) << checked.said();
  EXPECT_EQ(checked.diagnostics.sorted()[0].changes, std::vector<std::string>{"ropes.headline.length=4.8 m"});
}

TEST(TriedCures, NothingIsProposedThatWasNotTried) {
  formats::Diagnostics said;
  const auto document =
      PlanDocument::parse(changed_plan("length = \"6 m\"", "length = \"4 m\""), "plan.toml", said);
  NetPlan plan = read_plan(document->root, document->catalogue, said);
  check_plan(plan, said);
  const std::string general = "lengthen the rope, or give its edges less of it";
  EXPECT_EQ(said.sorted()[0].hint, general);
  try_cures(document->root, document->catalogue, said, {.most = 0, .least = 0});
  EXPECT_EQ(said.sorted()[0].hint, general);
  EXPECT_TRUE(said.sorted()[0].changes.empty());
}

/// A change of the plan that turns an accepted warning into an error is no cure.
TEST(TriedCures, AnAcceptedWarningMayNotBecomeWorse) {
  const auto checked =
      check_text(replaced(library_text("83-112-eastern.toml"), "meshes = 72", "meshes = 720"));
  const std::string hint = hint_of(checked, "hang[0]");
  EXPECT_TRUE(hint.starts_with("panels.top-body.fore[0].meshes = 72")) << checked.said();
}

}  // namespace
}  // namespace netloft::gears
