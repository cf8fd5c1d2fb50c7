// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/gear_mesh.hpp"

#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/plan/twine_coordinates.hpp"
#include "tests/unit/io/gears/plan/divided.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace netloft::gears {
namespace {

/// A meshed gear and the plan to which it refers.
struct Divided {
  CheckedPlan checked;
  Gear gear;
  GearMesh mesh;

  const PanelMesh& panel(const std::string& name) const {
    return mesh.panels[static_cast<std::size_t>(gear.find_panel(name) - gear.panels.data())];
  }
  const RopeMesh& rope(const std::string& name) const {
    return mesh.ropes[static_cast<std::size_t>(gear.find_rope(name) - gear.ropes.data())];
  }
  /// The nodes of an edge or a corner, by their numbers in the gear.
  std::vector<std::uint32_t> nodes(const std::string& panel_name, const std::string& set) const {
    std::vector<std::uint32_t> all;
    for (const auto own : panel(panel_name).sets.at(set)) all.push_back(panel(panel_name).nodes[own]);
    return all;
  }
};

Fineness by_nodes(std::size_t nodes) {
  Fineness fineness;
  fineness.nodes = nodes;
  return fineness;
}

Fineness by_size(double size) {
  Fineness fineness;
  fineness.size = size;
  return fineness;
}

Divided divided(const std::string& text, Extent extent, const Fineness& fineness) {
  Divided all{check_text(text), {}, {}};
  EXPECT_EQ(all.checked.diagnostics.errors(), 0u) << all.checked.said();
  all.gear = make_gear(all.checked.plan, extent);
  all.mesh = divide(all.gear, fineness);
  return all;
}

const std::vector<std::string> kLibrary = {"83-112-eastern.toml", "codend-100-round.toml", "four-panel.toml",
                                           "two-panel.toml"};

/// Calls `test` with all gears of the library and the good plan, whole and half.
template <class Test>
void with_all_gears(const Fineness& fineness, Test test) {
  std::vector<std::string> texts{kGoodPlan};
  for (const auto& name : kLibrary) texts.push_back(library_text(name));
  for (std::size_t k = 0; k < texts.size(); ++k)
    for (const Extent extent : {Extent::whole, Extent::half}) {
      SCOPED_TRACE((k ? kLibrary[k - 1] : "good plan") + (extent == Extent::half ? ", half" : ", whole"));
      test(divided(texts[k], extent, fineness));
    }
}

TEST(GearMesh, HasTheAreaOfItsOutlines) {
  for (const std::size_t nodes : {500u, 2000u})
    with_all_gears(by_nodes(nodes), [](const Divided& all) { expect_areas(all.gear, all.mesh); });
}

Fineness by_knots() {
  Fineness fineness;
  fineness.knots = true;
  return fineness;
}

/// A plan of one rectangle.
std::string rectangle(const std::string& more) {
  return "[panels.net]\nstands = \"alone\"\nmesh = \"0.1 m\"\ntwine = { diameter = \"2 mm\", EA = 1000, "
         "density = 1140 }\n"
         "fore = 12\ndepth = 9\nouter = \"AN\"\ninner = \"AN\"\nopen = [\"fore\", \"aft\", \"outer\", "
         "\"inner\"]\n" +
         more;
}

/// Whether two sides of a triangle are single bars, one in each twine direction.
bool is_between_knots(const PanelMesh& panel, std::size_t t, const Panel& plan) {
  std::set<std::array<double, 2>> bars;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = panel.meshes[panel.triangles[3 * t + k]],
               b = panel.meshes[panel.triangles[3 * t + (k + 1) % 3]];
    const auto from = twine_coordinates(plan.orientation, plan.angle, a[0], a[1]),
               to = twine_coordinates(plan.orientation, plan.angle, b[0], b[1]);
    const double u = std::abs(to[0] - from[0]), v = std::abs(to[1] - from[1]);
    if (std::abs(u + v - 1) < 1e-9 && std::min(u, v) < 1e-9) bars.insert({std::round(u), std::round(v)});
  }
  return bars.size() == 2;
}

TEST(GearMeshByKnots, HasEveryKnotOfARectangleForANodeAndNoOther) {
  for (const char* orientation : {"diamond", "t90"}) {
    const Divided all =
        divided(rectangle("orientation = \"" + std::string(orientation) + "\"\n"), Extent::whole, by_knots());
    EXPECT_EQ(all.mesh.nodes, 13u * 10 + 12 * 9);
    const PanelMesh& net = all.mesh.panels[0];
    for (std::size_t t = 0; t < net.triangles.size() / 3; ++t)
      EXPECT_TRUE(is_between_knots(net, t, *all.gear.panels[0].panel)) << t;
  }
}
TEST(GearMeshByKnots, HasEveryKnotOfSquareNettingToo) {
  const Divided all = divided(rectangle("orientation = \"square\"\n"), Extent::whole, by_knots());
  EXPECT_EQ(all.mesh.nodes, 13u * 10);
}
TEST(GearMeshByKnots, IsWithoutHolesAndHasTheAreaOfItsOutlines) {
  with_all_gears(by_knots(), [](const Divided& all) {
    expect_areas(all.gear, all.mesh);
    expect_closed_and_oriented(all.gear, all.mesh);
  });
}
// More than 95 % of the triangles have two bars between knots as sides; only triangles at borders do not.
TEST(GearMeshByKnots, HasTrianglesBetweenKnotsButForItsBorders) {
  const Divided all = divided(library_text("codend-100-round.toml"), Extent::whole, by_knots());
  for (std::size_t p = 0; p < all.mesh.panels.size(); ++p) {
    const PanelMesh& panel = all.mesh.panels[p];
    const std::size_t count = panel.triangles.size() / 3;
    std::size_t between = 0;
    for (std::size_t t = 0; t < count; ++t) between += is_between_knots(panel, t, *all.gear.panels[p].panel);
    EXPECT_GT(static_cast<double>(between), 0.95 * static_cast<double>(count)) << all.gear.panels[p].name;
  }
}

TEST(GearMesh, IsWithoutHolesAndShowsOneFaceOutwards) {
  for (const std::size_t nodes : {100u, 500u, 2000u})
    with_all_gears(by_nodes(nodes),
                   [](const Divided& all) { expect_closed_and_oriented(all.gear, all.mesh); });
}

void expect_about(std::size_t nodes, const GearMesh& mesh) {
  const auto asked = static_cast<double>(nodes);
  EXPECT_NEAR(static_cast<double>(mesh.nodes), asked, 0.15 * asked);
}

TEST(GearMesh, HasAboutAsManyNodesAsAreAskedFor) {
  for (const std::size_t nodes : {500u, 2000u})
    with_all_gears(by_nodes(nodes), [&](const Divided& all) { expect_about(nodes, all.mesh); });
  for (const std::size_t nodes : {8000u, 30000u})
    expect_about(nodes, divided(library_text("four-panel.toml"), Extent::half, by_nodes(nodes)).mesh);
}

TEST(GearMesh, NumbersItsNodesWithoutGaps) {
  with_all_gears(by_nodes(500), [](const Divided& all) {
    std::vector<int> used(all.mesh.nodes, 0);
    for (const auto& panel : all.mesh.panels)
      for (const auto node : panel.nodes) used.at(node) = 1;
    for (const auto& rope : all.mesh.ropes)
      for (const auto node : rope.nodes) used.at(node) = 1;
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
  });
}

TEST(GearMesh, HasNoSlivers) {
  with_all_gears(by_nodes(2000), [](const Divided& all) {
    const MeshQuality quality = quality_of(all.gear, all.mesh);
    EXPECT_GT(quality.least_angle, 17 * std::numbers::pi / 180);
    EXPECT_LT(quality.greatest_angle, 140 * std::numbers::pi / 180);
    std::size_t triangles = 0;
    for (const auto& panel : all.mesh.panels) triangles += panel.triangles.size() / 3;
    EXPECT_EQ(quality.triangles, triangles);
  });
}

TEST(GearMesh, SewnEdgesHaveTheSameNodes) {
  with_all_gears(by_nodes(2000), [](const Divided& all) {
    for (const auto& seam : all.gear.seams) {
      std::array<std::set<std::uint32_t>, 2> nodes;
      for (std::size_t r = 0; r < 2; ++r)
        for (const auto& ref : seam.edges[r])
          for (const auto node : all.nodes(all.gear.panels[ref.panel].name,
                                           all.gear.panels[ref.panel].outline.edges[ref.edge].name))
            nodes[r].insert(node);
      EXPECT_EQ(nodes[0], nodes[1]) << all.gear.name_of(seam.edges[0][0]);
      EXPECT_GE(nodes[0].size(), 3u);
    }
  });
}

/// 60 meshes are sewn to 56: each node must be at the same fraction of both edges.
TEST(GearMesh, TakeUpIsSpreadEvenlyOverTheSeam) {
  const auto all = divided(library_text("83-112-eastern.toml"), Extent::half, by_nodes(2000));
  const auto &body = all.panel("top-body"), &bag = all.panel("top-intermediate");
  std::map<std::uint32_t, double> at;
  for (const auto own : bag.sets.at("fore")) at[bag.nodes[own]] = bag.meshes[own][0] / 30;
  for (const auto own : body.sets.at("aft"))
    EXPECT_NEAR(body.meshes[own][0] / 28, at.at(body.nodes[own]), 1e-9);
}

TEST(GearMesh, RestLengthsAddUpToTheRopes) {
  with_all_gears(by_nodes(500), [](const Divided& all) {
    for (std::size_t r = 0; r < all.gear.ropes.size(); ++r) {
      const auto& rope = all.mesh.ropes[r];
      ASSERT_EQ(rope.rest_lengths.size() + 1, rope.nodes.size());
      const double sum = std::accumulate(rope.rest_lengths.begin(), rope.rest_lengths.end(), 0.0);
      EXPECT_NEAR(sum, all.gear.ropes[r].length, 1e-9 * sum) << all.gear.ropes[r].name;
      for (const double l : rope.rest_lengths) EXPECT_GT(l, 0);
    }
  });
}

/// A rope has the nodes of the edge that is hung on it, in the same order.
TEST(GearMesh, RopesRunAlongTheNodesOfTheirEdges) {
  const auto all = divided(library_text("four-panel.toml"), Extent::whole, by_nodes(500));
  EXPECT_EQ(all.rope("headline").nodes, all.nodes("top", "fore"));
  auto breast = all.nodes("starboard-side", "fore");
  std::reverse(breast.begin(), breast.end());  // from the end of the headline down to that of the footrope
  EXPECT_EQ(all.rope("starboard-breast-line").nodes, breast);
}

/// The edges of the two wings take 36 ft each and that of the bosom 11.9 ft, 83.9 ft in all. The rope is
/// shorter, so that each edge gets its share of the length.
TEST(GearMesh, RopesTakeTheSharesOfTheirEdges) {
  const auto all = divided(library_text("83-112-eastern.toml"), Extent::half, by_nodes(2000));
  const auto& rope = all.rope("headrope");
  const std::size_t bosom = all.panel("top-body").sets.at("bosom").size() - 1;
  const double sum = std::accumulate(rope.rest_lengths.begin(),
                                     rope.rest_lengths.begin() + static_cast<std::ptrdiff_t>(bosom), 0.0);
  EXPECT_NEAR(sum, 12.65 * 5.95 / (5.95 + 36), 1e-9);
}

TEST(GearMesh, PointsThatAreOneAreOneNode) {
  const auto all = divided(library_text("83-112-eastern.toml"), Extent::whole, by_nodes(500));
  const auto& at = all.mesh.points;
  EXPECT_EQ(at.at("headrope.end"), at.at("starboard-top-wing.fore-inner"));
  EXPECT_EQ(at.at("headrope.start"), at.at("port-upper-bridle.end"));
  EXPECT_EQ(at.at("starboard-lower-bridle.end"), at.at("starboard-lower-extension.start"));
  EXPECT_EQ(at.at("starboard-towing-point"), at.at("starboard-upper-bridle.start"));
  EXPECT_EQ(at.at("top-body.starboard-aft-outer"), at.at("bottom-intermediate.starboard-fore-outer"));
  EXPECT_EQ(at.at("headrope.middle"), at.at("top-body.fore-inner"));
  EXPECT_NE(at.at("port-towing-point"), at.at("starboard-towing-point"));
}

TEST(GearMesh, RopesLongerThanTheirEdgesHaveFreeEnds) {
  const auto all = divided(kGoodPlan, Extent::half, by_nodes(200));
  EXPECT_NE(all.mesh.points.at("headline.end"), all.mesh.points.at("wing.fore-inner"));
  const auto& rope = all.rope("headline");
  const auto tip = std::find(rope.nodes.begin(), rope.nodes.end(), all.mesh.points.at("wing.fore-inner"));
  const auto hung = rope.rest_lengths.begin() + (tip - rope.nodes.begin());
  EXPECT_NEAR(std::accumulate(rope.rest_lengths.begin(), hung, 0.0), 0.5 + 1.9, 1e-9);
}

TEST(GearMesh, HalvesLieOnThePlaneOfSymmetry) {
  const auto all = divided(library_text("83-112-eastern.toml"), Extent::half, by_nodes(500));
  const std::set<std::uint32_t> middle(all.mesh.middle.begin(), all.mesh.middle.end());
  for (std::size_t p = 0; p < all.gear.panels.size(); ++p)
    for (std::size_t k = 0; k < all.mesh.panels[p].nodes.size(); ++k)
      if (all.gear.panels[p].panel->stands == Standing::middle) {
        EXPECT_EQ(middle.contains(all.mesh.panels[p].nodes[k]), all.mesh.panels[p].meshes[k][0] == 0);
      }
  EXPECT_TRUE(middle.contains(all.rope("footrope").nodes.front()));
}

using Meshes = std::multiset<std::array<double, 2>>;

Meshes meshes_of(const PanelMesh& panel, double sign) {
  Meshes all;
  for (const auto& at : panel.meshes)
    all.insert({std::round(1e6 * (at[0] == 0 ? 0 : sign * at[0])), std::round(1e6 * at[1])});
  return all;
}

TEST(GearMesh, IsTheSameToPortAndToStarboard) {
  for (const auto& name : kLibrary) {
    const auto all = divided(library_text(name), Extent::whole, by_nodes(2000));
    for (std::size_t p = 0; p < all.gear.panels.size(); ++p) {
      const auto& panel = all.gear.panels[p];
      const std::string starboard = "starboard-" + panel.panel->name;
      if (panel.panel->stands == Standing::middle)
        EXPECT_EQ(meshes_of(all.mesh.panels[p], 1), meshes_of(all.mesh.panels[p], -1)) << panel.name;
      else
        EXPECT_EQ(meshes_of(all.mesh.panels[p], 1), meshes_of(all.panel(starboard), 1)) << panel.name;
    }
  }
}

/// Mean length of the sides of triangles in half-open netting.
double mean_side(const Divided& all, const std::string& name) {
  const auto& mesh = all.panel(name);
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = mesh.meshes[mesh.triangles[t + k]], &b = mesh.meshes[mesh.triangles[t + (k + 1) % 3]];
      const PanelPoint d = spread(*all.gear.find_panel(name)->panel, {b[0] - a[0], b[1] - a[1]});
      sum += std::hypot(d.x, d.y);
    }
  return sum / static_cast<double>(mesh.triangles.size());
}

TEST(GearMesh, SidesAreAboutAsLongAsAskedFor) {
  const auto all = divided(library_text("83-112-eastern.toml"), Extent::half, by_size(0.2));
  for (const char* panel : {"top-wing", "top-body", "bottom-body"})
    EXPECT_NEAR(mean_side(all, panel), 0.2, 0.15 * 0.2) << panel;
  const auto& bridle = all.rope("upper-bridle").rest_lengths;
  for (const double l : bridle) EXPECT_NEAR(l, 0.2, 0.01 * 0.2);
}

TEST(GearMesh, PartsMayBeFinerThanOthers) {
  Fineness fineness = by_size(0.3);
  fineness.finer = {{"top-wing", 3}, {"upper-bridle", 2}};
  const auto all = divided(library_text("83-112-eastern.toml"), Extent::half, fineness);
  EXPECT_NEAR(mean_side(all, "top-wing"), 0.1, 0.15 * 0.1);
  EXPECT_NEAR(mean_side(all, "bottom-body"), 0.3, 0.15 * 0.3);
  EXPECT_NEAR(all.rope("upper-bridle").rest_lengths[0], 0.15, 0.01);
  EXPECT_NEAR(all.rope("lower-bridle").rest_lengths[0], 0.3, 0.02);
  expect_closed_and_oriented(all.gear, all.mesh);
}

/// A rib rope along a seam must have the nodes of the seam.
TEST(GearMesh, EdgesMayBeSewnAndHung) {
  const auto all = divided(library_text("four-panel.toml") + R"(
[ropes.rib]
stands = "pair"
rope = { diameter = "12 mm", EA = "100 kN", density = 1000 }
length = "7 m"
[[hang]]
edge = "side.outer"
on = "rib"
length = "7 m"
)",
                           Extent::half, by_nodes(500));
  EXPECT_EQ(all.rope("rib").nodes, all.nodes("side", "outer"));
  const auto seam = all.nodes("top", "sides");
  EXPECT_EQ(all.rope("rib").nodes, seam);
}

TEST(GearMesh, TubesAreSewnToThemselves) {
  const std::string text = R"(
[panels.bag]
mesh = "80 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
round = 60
depth = 50
)";
  const auto all = divided(text, Extent::whole, by_nodes(300));
  expect_closed_and_oriented(all.gear, all.mesh);
  expect_areas(all.gear, all.mesh);
  const auto half = divided(text, Extent::half, by_nodes(300));
  const std::set<std::uint32_t> middle(half.mesh.middle.begin(), half.mesh.middle.end());
  for (const auto node : half.nodes("bag", "sides")) EXPECT_TRUE(middle.contains(node));
}

/// The text of a panel; `more` has `fore` or `round`, and other keys.
std::string panel_of(const std::string& name, const std::string& more) {
  return "[panels." + name + "]\nmesh = \"80 mm\"\ndepth = 30\n" +
         "twine = { diameter = \"2 mm\", EA = \"3 kN\", density = 960 }\n" + more + "\n";
}

std::string join_of(const std::string& one, const std::string& other) {
  return "[[join]]\nedges = [" + one + ", " + other + "]\n";
}

/// Expects a mesh without holes. The nodes of the bag's mouth are the aft nodes of the panels in `row`, and
/// the last panel of `row` reaches the middle of the lower side.
void expect_ring(const std::string& plan, const std::vector<std::string>& row) {
  for (const Extent extent : {Extent::whole, Extent::half}) {
    SCOPED_TRACE(extent == Extent::half ? "half" : "whole");
    const auto all = divided(plan, extent, by_nodes(400));
    expect_closed_and_oriented(all.gear, all.mesh);
    expect_areas(all.gear, all.mesh);
    std::set<std::uint32_t> ring;
    for (const auto& panel : all.gear.panels)
      if (std::count(row.begin(), row.end(), panel.panel->name) > 0)
        for (const auto node : all.nodes(panel.name, "aft")) ring.insert(node);
    const auto mouth = all.nodes("bag", "fore"), below = all.nodes(row.back(), "aft");
    EXPECT_EQ(ring, std::set<std::uint32_t>(mouth.begin(), mouth.end()));
    const auto middle_below = extent == Extent::half ? mouth.back() : mouth.front();
    EXPECT_TRUE(std::find(below.begin(), below.end(), middle_below) != below.end());
  }
}

TEST(GearMesh, RowsGoRoundTheNetBeforeATube) {
  const std::string ahead = "fore = 30\nsides = \"AN\"\nopen = \"fore\"";
  const std::string panels = panel_of("upper", ahead) + panel_of("lower", ahead),
                    bag = panel_of("bag", "round = 60"), closed = join_of("\"bag.aft\"", "\"bag.aft\""),
                    sides = join_of("\"upper.sides\"", "\"lower.sides\"");
  for (const std::string& order : {panels + bag, bag + panels}) {
    expect_ring(order + sides + closed + join_of("[\"upper.aft\", \"lower.aft\"]", "\"bag.fore\""),
                {"upper", "lower"});
    expect_ring(order + join_of("[\"lower.aft\", \"upper.aft\"]", "\"bag.fore\"") + closed + sides,
                {"lower", "upper"});
  }
}

TEST(GearMesh, RowsGoRoundTheNetByWayOfSidePanels) {
  const std::string ahead = "fore = 30\nsides = \"AN\"\nopen = \"fore\"";
  const std::string panels =
      panel_of("upper", ahead) + panel_of("lower", ahead) + panel_of("bag", "round = 90\nopen = \"aft\"") +
      panel_of("side", "stands = \"pair\"\nfore = 15\nouter = \"AN\"\ninner = \"AN\"\nopen = \"fore\"");
  const std::string ring = join_of("[\"upper.aft\", \"side.aft\", \"lower.aft\"]", "\"bag.fore\"");
  for (const bool is_inner_above : {true, false}) {
    SCOPED_TRACE(is_inner_above ? "inner side above" : "outer side above");
    const std::string seams =
        join_of("\"upper.sides\"", is_inner_above ? "\"side.inner\"" : "\"side.outer\"") +
        join_of("\"lower.sides\"", is_inner_above ? "\"side.outer\"" : "\"side.inner\"");
    expect_ring(panels + seams + ring, {"upper", "side", "lower"});
    expect_ring(panels + ring + seams, {"upper", "side", "lower"});
  }
}

TEST(GearMesh, TubesOfSeveralCutsAreSewnCutToCut) {
  const auto all = divided(panel_of("bag",
                                    "round = 60\nopen = [\"fore\", \"aft\"]\n"
                                    "sides = [{ name = \"straight\", cut = \"AN\", depth = 10 }, { name = "
                                    "\"taper\", cut = \"1N2B in\" }]"),
                           Extent::whole, by_nodes(300));
  expect_closed_and_oriented(all.gear, all.mesh);
  for (const char* cut : {"straight", "taper"}) {
    const auto port = all.nodes("bag", std::string("port-") + cut),
               starboard = all.nodes("bag", std::string("starboard-") + cut);
    EXPECT_EQ(std::set<std::uint32_t>(port.begin(), port.end()),
              std::set<std::uint32_t>(starboard.begin(), starboard.end()));
  }
}

TEST(GearMesh, ATubeMayBeSewnToARing) {
  const auto all = divided(panel_of("ring", "round = 60") + join_of("\"ring.fore\"", "\"ring.aft\""),
                           Extent::whole, by_nodes(300));
  expect_closed_and_oriented(all.gear, all.mesh);
  expect_areas(all.gear, all.mesh);
}

const std::string kFlat = "stands = \"alone\"\nfore = 30\nouter = \"AN\"\ninner = \"AN\"\n";

TEST(GearMesh, ASideIsSewnToAnEndFromTheirCommonCorner) {
  const auto all = divided(
      panel_of("flat", kFlat + "open = [\"inner\", \"aft\"]") + join_of("\"flat.fore\"", "\"flat.outer\""),
      Extent::whole, by_nodes(200));
  expect_closed_and_oriented(all.gear, all.mesh);
  expect_areas(all.gear, all.mesh);
  auto fore = all.nodes("flat", "fore");
  std::reverse(fore.begin(), fore.end());
  EXPECT_EQ(fore, all.nodes("flat", "outer"));
}

TEST(GearMesh, SidesInARowAreMirrorImages) {
  const std::string plan = panel_of("upper", "fore = 30\nsides = \"AN\"\nopen = [\"fore\", \"aft\"]") +
                           panel_of("lower", "fore = 60\nsides = \"AN\"\nopen = [\"sides\", \"aft\"]") +
                           join_of("\"upper.sides\"", "\"lower.fore\"");
  const auto all = divided(plan, Extent::whole, by_nodes(300));
  expect_closed_and_oriented(all.gear, all.mesh);
  EXPECT_EQ(all.mesh.points.at("upper.port-fore-outer"), all.mesh.points.at("lower.fore-inner"));
  EXPECT_EQ(all.mesh.points.at("upper.starboard-fore-outer"), all.mesh.points.at("lower.fore-inner"));
  EXPECT_EQ(all.mesh.points.at("upper.port-aft-outer"), all.mesh.points.at("lower.port-fore-outer"));
}

TEST(GearMesh, SeamsThatTwistTheNetAreRefusedWithTheirNames) {
  const std::string panels = panel_of("ahead", kFlat + "open = [\"inner\", \"fore\"]") +
                             panel_of("behind", kFlat + "open = [\"inner\", \"aft\"]");
  const auto checked = check_text(panels + join_of("\"ahead.aft\"", "\"behind.fore\"") +
                                  join_of("\"ahead.outer\"", "\"behind.outer\""));
  const std::string said = checked.said();
  EXPECT_NE(said.find("the seam of ahead.outer and behind.outer, together with those of ahead.aft and "
                      "behind.fore, would twist the net"),
            std::string::npos)
      << said;
  EXPECT_EQ(checked.diagnostics.errors(), 1) << said;
  for (const auto& finding : checked.diagnostics.sorted()) EXPECT_EQ(finding.place.line, 21) << said;
  EXPECT_THROW(divide(make_gear(checked.plan, Extent::whole), by_nodes(300)), CannotDivide);
}

TEST(GearMesh, AnEndMayBeSewnToItsMirrorImage) {
  const auto whole = divided(library_text("two-panel.toml"), Extent::whole, by_nodes(500));
  auto line = whole.nodes("bag", "aft");
  std::sort(line.begin(), line.end());
  std::size_t once = 0;  // the ends of the line
  for (std::size_t k = 0; k < line.size(); ++k) once += std::count(line.begin(), line.end(), line[k]) == 1;
  EXPECT_LE(once, 1u);
  const auto half = divided(library_text("two-panel.toml"), Extent::half, by_nodes(500));
  const std::set<std::uint32_t> middle(half.mesh.middle.begin(), half.mesh.middle.end());
  for (const auto node : half.nodes("bag", "aft")) EXPECT_TRUE(middle.contains(node));
}

}  // namespace
}  // namespace netloft::gears
