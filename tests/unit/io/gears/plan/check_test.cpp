// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/io/gears/plan/plans.hpp"

namespace netloft::gears {
namespace {

bool says(const CheckedPlan& checked, const std::string& words) {
  return checked.said().find(words) != std::string::npos;
}

/// Whether the plan accepts a warning that begins with these words.
bool accepts(const CheckedPlan& checked, const std::string& words) {
  for (const auto& warning : checked.diagnostics.accepted())
    if (warning.message.starts_with(words)) return true;
  return false;
}

std::string with_the_slip() {
  std::string text = library_text("83-112-eastern.toml");
  const std::string right = "cut = \"3B1M out\"";
  return text.replace(text.find(right), right.size(), "cut = \"381M out\"");
}

/// The wing of the published plan, computed by hand: 3 + 43 + 133.7 - 70·2.5/3.5 = 129.7 meshes.
TEST(EasternTrawl, TheLibraryGearCanBeSewn) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  EXPECT_EQ(checked.diagnostics.errors() + checked.diagnostics.warnings(), 0) << checked.said();
  EXPECT_TRUE(
      accepts(checked, "top-wing.aft: the cuttings give 129.7 meshes, but the plan says 127.5, +1.7 %"));
}

/// The edges need 2·36 + 11.9 ft = 83.9 ft = 25.57 m of the headrope, which is 83 ft = 25.3 m long.
TEST(EasternTrawl, TheHeadropeIsAFootShort) {
  EXPECT_TRUE(accepts(check_text(library_text("83-112-eastern.toml")),
                      "headrope is 25.3 m long, but edges take 25.57 m of it"));
}

TEST(EasternTrawl, TheSlipOfThePrintedPlanIsFoundAndNamed) {
  const auto checked = check_text(with_the_slip());
  EXPECT_EQ(checked.diagnostics.errors(), 1) << checked.said();
  EXPECT_TRUE(
      says(checked, "top-wing.breast-cut: cutting \"381M\" is not a rate; 3B1M, 43 M over 25.8 M, fits"))
      << checked.said();
  EXPECT_TRUE(
      accepts(checked, "top-wing.aft: the cuttings give 129.7 meshes, but the plan says 127.5, +1.7 %"));
}

TEST(EasternTrawl, TheSlipIsFoundAlsoWhereTheOtherCutTakesTheRest) {
  std::string text = with_the_slip();
  const std::string depth = ", depth = 70 }";
  text.replace(text.find(depth), depth.size(), " }");
  const auto checked = check_text(text);
  EXPECT_TRUE(says(checked, "3B1M, 43 M over 25.8 M, fits")) << checked.said();
  EXPECT_TRUE(says(checked, "the cuttings give 129.9 meshes")) << checked.said();
}

/// The cuttings of the bottom body miss its aft count by 0.71 meshes; seams can take up one mesh.
TEST(PlanCheck, AMeshMoreOrLessIsNotTold) {
  EXPECT_FALSE(says(check_text(library_text("83-112-eastern.toml")), "bottom-body.aft"));
}

TEST(PlanCheck, TakeUpIsTheRatioOfMeshes) {
  const std::string join = "edges = [\"body.aft\", \"bag.fore\"]";
  const auto checked = check_text(changed_plan("fore = 20\ndepth = 50", "fore = 25\ndepth = 50"));
  EXPECT_TRUE(says(checked, "join[1]: body.aft has 20 meshes, but bag.fore has 25 meshes, +25.0 %"))
      << checked.said();
  std::string text = changed_plan("fore = 20\ndepth = 50", "fore = 25\ndepth = 50");
  text.replace(text.find(join), join.size(), join + "\ntake_up = 1.25");
  EXPECT_FALSE(says(check_text(text), "join[1]"));
}

TEST(PlanCheck, SidesOfOtherMeshesAreMeasuredAlongTheirTwines) {
  std::string text = kGoodPlan;
  const std::string bag = "fore = 20\ndepth = 50\nsides = \"AN\"\n";
  text.replace(text.find(bag), bag.size(), bag + R"(
[panels.cover]
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = 20
depth = 40
sides = "AN"
)");
  text += "[[join]]\nedges = [\"bag.sides\", \"cover.sides\"]\n";  // 50 meshes of 80 mm and 40 of 100 mm: 4 m
                                                                   // each
  const auto checked = check_text(text);
  EXPECT_FALSE(says(checked, "join[2]")) << checked.said();
}

TEST(PlanCheck, AHangingMayTakeTheStretchedLengthAndNoMore) {
  EXPECT_EQ(check_text(changed_plan("length = \"1.9 m\"", "length = \"2 m\"")).diagnostics.errors(), 0);
  const auto checked = check_text(changed_plan("length = \"1.9 m\"", "length = \"2.1 m\""));
  EXPECT_TRUE(says(checked, "wing.inner is 2 m long when its meshes are stretched")) << checked.said();
}

/// A rib rope is hung on the edges of a seam.
TEST(PlanCheck, AnEdgeMayBeBothSewnAndHung) {
  const auto checked = check_text(kGoodPlan + R"(
[ropes.rib]
rope = { diameter = "12 mm", EA = "100 kN", density = 1000 }
length = "3 m"
[[hang]]
edge = "wing.aft"
on = "rib"
length = "2.7 m"
)");
  EXPECT_EQ(checked.diagnostics.errors(), 0) << checked.said();
}

TEST(PlanCheck, ARopeOfTheMiddleCarriesBothWings) {
  const auto checked = check_text(changed_plan("length = \"6 m\"", "length = \"4 m\""));
  EXPECT_TRUE(says(checked, "headline is 4 m long, but edges take 4.8 m of it: it is 0.8 m too short"))
      << checked.said();
}

TEST(Check, TakesAMeshSizeOfMetresWithItsUnitOnly) {
  std::string plan = kGoodPlan;
  const auto at = plan.find("mesh = ");
  plan.replace(at, plan.find('\n', at) - at, "mesh = 60");
  const std::string said = check_text(plan).said();
  EXPECT_NE(
      said.find("panels.wing.mesh: 60 means meshes of 60 m, because numbers without a unit are in metres"),
      std::string::npos)
      << said;
  EXPECT_NE(said.find("write mesh = \"60 mm\""), std::string::npos) << said;
  plan.replace(plan.find("mesh = 60"), 9, "mesh = \"60 m\"");
  EXPECT_EQ(check_text(plan).said().find("means meshes"), std::string::npos);
}

}  // namespace
}  // namespace netloft::gears
