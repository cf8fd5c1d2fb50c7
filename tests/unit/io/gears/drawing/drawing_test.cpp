// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/drawing/drawing.hpp"

#include "io/gears/drawing/plan_layout.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

namespace netloft::gears {
namespace {

const PlacedPanel& placed(const std::vector<PlacedPanel>& panels, const std::string& name,
                          bool mirrored = false) {
  for (const auto& p : panels)
    if (p.panel->name == name && p.is_mirrored == mirrored) return p;
  ADD_FAILURE() << name << " is not on the drawing";
  return panels.front();
}

/// Panels are drawn to scale: stretched length aft, half of the stretched width across (ISO 3169).
TEST(Layout, DrawsStretchedLengthByHalfOfTheStretchedWidth) {
  const auto checked = check_text(kGoodPlan);
  const auto panels = lay_out(checked.plan);
  const auto& body = placed(panels, "body");
  const PanelPoint corner = body.on_sheet({40, 42});
  EXPECT_NEAR(corner.x - body.x, 0.5 * 40 * 0.1, 1e-12);
  EXPECT_NEAR(corner.y - body.y, 42 * 0.1, 1e-12);
}

TEST(Layout, SewsPanelsTogether) {
  const auto checked = check_text(kGoodPlan);
  const auto panels = lay_out(checked.plan);
  const PanelPoint wing = placed(panels, "wing").on_sheet({10, 20}),
                   body = placed(panels, "body").on_sheet({40, 0});
  EXPECT_NEAR(wing.x, body.x, 1e-12);
  EXPECT_NEAR(wing.y, body.y, 1e-12);
  EXPECT_NEAR(placed(panels, "bag").on_sheet({0, 0}).y, placed(panels, "body").on_sheet({0, 42}).y, 1e-12);
}

TEST(Layout, MirrorsPairsAboutTheMiddleOfTheirColumn) {
  const auto checked = check_text(kGoodPlan);
  const auto panels = lay_out(checked.plan);
  const double middle = placed(panels, "body").x;
  const PanelPoint starboard = placed(panels, "wing").on_sheet({10, 0}),
                   port = placed(panels, "wing", true).on_sheet({10, 0});
  EXPECT_NEAR(starboard.x - middle, middle - port.x, 1e-12);
}

TEST(Drawing, NamesPanelsCountsCuttingsTwinesAndRopes) {
  const std::string svg = draw_plan(check_text(library_text("83-112-eastern.toml")).plan);
  for (const char* words : {"top-wing", "5B1P", "3B1M", "127.5", "128.5", "101.6 mm", "pa-twisted-2.3mm",
                            "headrope: 25.3 m", "47 83-112-headline along headrope", "<svg"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
}

/// Each side of a triangle is a line, and the borders are drawn over these lines.
TEST(Drawing, OfTrianglesHasAllTheirSides) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::whole);
  Fineness fineness;
  fineness.nodes = 300;
  const GearMesh mesh = divide(gear, fineness);
  const std::string svg = draw_mesh(checked.plan, gear, mesh);
  std::size_t lines = 0;
  for (auto at = svg.find("<line"); at != std::string::npos; at = svg.find("<line", at + 1)) ++lines;
  EXPECT_GT(lines, 3 * mesh.quality.triangles / 2);
  EXPECT_NE(svg.find(std::to_string(mesh.nodes) + " nodes"), std::string::npos);
}

TEST(Drawing, OfAPlanWithoutPanelsIsAnEmptySheet) {
  EXPECT_NE(draw_plan({}).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace netloft::gears
