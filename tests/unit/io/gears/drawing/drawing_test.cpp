// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/drawing/drawing.hpp"

#include "io/gears/drawing/lettering.hpp"
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

std::string svg_of(const NetPlan& plan) {
  formats::SvgPicture picture;
  return picture.finish(draw_plan(plan, picture), 1000);
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

/// Upper and lower panel are sewn to the mouth of the same tube: they are drawn beside each other.
TEST(Layout, PutsNoMiddlePanelOnAnother) {
  const auto checked = check_text(library_text("two-panel.toml"));
  const auto panels = lay_out(checked.plan);
  EXPECT_GT(std::abs(placed(panels, "upper").x - placed(panels, "lower").x), 0.5 * 0.06 * 140);
  EXPECT_NEAR(placed(panels, "upper").x, placed(panels, "bag").x, 1e-12);
}

/// Side panels that are sewn to the same tube as the top of the net have a separate column, too.
TEST(Layout, PutsNoPairOnAMiddlePanel) {
  std::ifstream file(test::source_folder() + "/io/program/templates/four-panel/my_gear.toml");
  const auto checked = check_text({std::istreambuf_iterator<char>(file), {}});
  const auto panels = lay_out(checked.plan);
  const PanelPoint corner = placed(panels, "top").on_sheet({56, 0}),
                   inner = placed(panels, "side", true).on_sheet({52, 0});
  EXPECT_GT(inner.x, corner.x);
}

TEST(Drawing, NamesPanelsCountsCuttingsTwinesAndRopes) {
  const std::string svg = svg_of(check_text(library_text("83-112-eastern.toml")).plan);
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
  formats::SvgPicture picture;
  const std::string svg = picture.finish(draw_mesh(checked.plan, gear, mesh, picture), 1000);
  std::size_t lines = 0;
  for (auto at = svg.find("<line"); at != std::string::npos; at = svg.find("<line", at + 1)) ++lines;
  EXPECT_GT(lines, 3 * quality_of(gear, mesh).triangles / 2);
  EXPECT_NE(svg.find(std::to_string(mesh.nodes) + " nodes"), std::string::npos);
}

/// A drawing that only records its texts.
class Texts : public formats::LineDrawing {
 public:
  struct Text {
    formats::PicturePoint at;
    std::string text;
  };
  void line(formats::PicturePoint, formats::PicturePoint, const char*, double) override {}
  void text(formats::PicturePoint at, const std::string& text, double, const char*,
            formats::Anchor) override {
    all.push_back({at, text});
  }
  formats::PicturePoint place_of(const std::string& text) const {
    for (const auto& one : all)
      if (one.text == text) return one.at;
    ADD_FAILURE() << text << " is not on the drawing";
    return {};
  }
  std::vector<Text> all;
};

/// The square is so short that four lines in its middle would cover the numbers at its edges.
TEST(Drawing, KeepsWordsOfShortPanelsOffTheNumbers) {
  Texts texts;
  draw_plan(check_text(R"(
[panels.square]
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = 80
depth = 4
aft = 70
sides = "4N5B in"
open = ["fore", "sides"]
[panels.belly]
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = 70
depth = 60
aft = 40
sides = "1N3B in"
open = ["sides", "aft"]
[[join]]
edges = ["square.aft", "belly.fore"]
)")
                .plan,
            texts);
  const auto square = texts.place_of("square"), fore = texts.place_of("80"), aft = texts.place_of("70");
  for (const auto& number : {fore, aft})
    EXPECT_TRUE(std::abs(square.y - number.y) > 11 || std::abs(square.x - number.x) > 30)
        << square.x << ' ' << square.y << ' ' << number.x << ' ' << number.y;
}

TEST(Drawing, BreaksLongLinesBelowThePanels) {
  const auto lines = broken_into_lines("one two three", 10, Lettering::length_of("one two", 10));
  EXPECT_EQ(lines, (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(broken_into_lines("", 10, 100), std::vector<std::string>{""});
}

TEST(Lettering, MovesTextsThatWouldBeCutAtTheEdge) {
  Texts texts;
  Lettering lettering(texts, 200);
  lettering.write({195, 20}, "twenty", 10, "#222", formats::Anchor::start);
  lettering.write({1, 40}, "twenty", 10, "#222", formats::Anchor::end);
  EXPECT_LT(texts.all[0].at.x + Lettering::length_of("twenty", 10), 200);
  EXPECT_GT(texts.all[1].at.x - Lettering::length_of("twenty", 10), 0);
}

TEST(Drawing, OfAPlanWithoutPanelsIsAnEmptySheet) { EXPECT_NE(svg_of({}).find("<svg"), std::string::npos); }

}  // namespace
}  // namespace netloft::gears
