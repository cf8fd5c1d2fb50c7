// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/io/gears/plan/plans.hpp"

namespace netloft::gears {
namespace {

TEST(NetPlan, CanBeSewn) {
  const auto checked = check_text(kGoodPlan);
  EXPECT_EQ(checked.diagnostics.errors() + checked.diagnostics.warnings(), 0) << checked.said();
}

TEST(NetPlan, CountsBothSidesOfAMiddlePanel) {
  const auto checked = check_text(kGoodPlan);
  const Panel& body = *checked.plan.find_panel("body");
  EXPECT_DOUBLE_EQ(body.count(body.fore), 80);
}

TEST(NetPlan, TheAftEdgeFollowsFromTheCuttingsWhereItIsNotSaid) {
  const auto checked = check_text(changed_plan("aft = 30\n", ""));
  const Panel& wing = *checked.plan.find_panel("wing");
  EXPECT_FALSE(wing.states_aft);
  EXPECT_DOUBLE_EQ(wing.count(wing.aft), 30);
}

TEST(NetPlan, ACutWithoutExtentTakesTheRestOfTheDepth) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  const Panel& wing = *checked.plan.find_panel("bottom-wing");
  EXPECT_DOUBLE_EQ(wing.outer[0].deep, 25.5);
  EXPECT_DOUBLE_EQ(wing.outer[1].deep, 124);
}

TEST(NetPlan, TwinesAndRopesComeFromTheCatalogue) {
  const auto checked = check_text(changed_plan(
      "twine = { diameter = \"2 mm\", EA = \"3 kN\", density = 960 }", "twine = \"pe-braided-4mm\""));
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  EXPECT_EQ(checked.plan.panels[0].twine_name, "pe-braided-4mm");
  EXPECT_DOUBLE_EQ(checked.plan.panels[0].twine_diameter, 0.004);
}

TEST(NetPlan, NettingStandsForMeshAndTwine) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  EXPECT_DOUBLE_EQ(checked.plan.panels[0].mesh, 0.1016);
  EXPECT_FALSE(checked.plan.panels[0].twine_name.empty());
}

TEST(NetPlan, ReadsHowManyPiecesStandAlongWhichRope) {
  const auto checked = check_text(kGoodPlan);
  EXPECT_DOUBLE_EQ(checked.plan.pieces[0].number, 11);
  EXPECT_EQ(checked.plan.pieces[0].along, "headline");
}

}  // namespace
}  // namespace netloft::gears
