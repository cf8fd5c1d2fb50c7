// SPDX-License-Identifier: BSD-3-Clause
#include "io/gear/gear_mesh.hpp"

#include "io/gear/cloths.hpp"
#include "tests/unit/io/gear/plans.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace netloft::io {
namespace {

/// A divided gear with all that it points into.
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
  /// Gear nodes of an edge or a corner.
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

const std::vector<std::string> kLibrary = {"83-112-eastern.toml", "codend-100-round.toml", "four-panel.toml"};

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

/// The shoelace formula.
double area_of(const Outline& outline) {
  double sum = 0;
  for (const auto& e : outline.edges) sum += (e.from.x * e.to.y - e.to.x * e.from.y) / 2;
  return sum;
}

double area_of(const PanelMesh& panel, std::size_t triangle) {
  std::array<std::array<double, 2>, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = panel.meshes[panel.triangles[3 * triangle + k]];
  return ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])) / 2;
}

/// Every triangle of a panel turns the same way, except that the other half of nothing is turned over.
void expect_areas(const GearPanel& panel, const PanelMesh& mesh) {
  double sum = 0, turned = 0;
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
    sum += std::abs(area_of(mesh, t));
    turned += area_of(mesh, t);
  }
  const double expected = area_of(panel.outline);
  EXPECT_NEAR(sum, expected, 1e-9 * expected) << panel.name;
  EXPECT_NEAR(std::abs(turned), expected, 1e-9 * expected) << panel.name;
}

using Side = std::pair<std::uint32_t, std::uint32_t>;

/// Sides of all triangles in gear nodes, in the direction of the triangle, and how often.
std::map<Side, int> sides_of(const GearMesh& mesh) {
  std::map<Side, int> sides;
  for (const auto& panel : mesh.panels)
    for (std::size_t t = 0; t < panel.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k)
        ++sides[{panel.nodes[panel.triangles[t + k]], panel.nodes[panel.triangles[t + (k + 1) % 3]]}];
  return sides;
}

/// Sides of the edges that are sewn to nothing.
std::set<Side> free_sides(const Divided& all) {
  std::set<std::pair<std::size_t, std::size_t>> sewn;
  for (const auto& seam : all.gear.seams)
    for (const auto& row : seam.edges)
      for (const auto& ref : row) sewn.insert({ref.panel, ref.edge});
  std::set<Side> sides;
  for (std::size_t p = 0; p < all.gear.panels.size(); ++p)
    for (std::size_t e = 0; e < all.gear.panels[p].outline.edges.size(); ++e) {
      const auto nodes = all.nodes(all.gear.panels[p].name, all.gear.panels[p].outline.edges[e].name);
      for (std::size_t k = 0; !sewn.contains({p, e}) && k + 1 < nodes.size(); ++k)
        sides.insert(std::minmax(nodes[k], nodes[k + 1]));
    }
  return sides;
}

/// A net without holes and without folds: each side of a triangle belongs to two of them that run along it
/// in opposite directions (so that all of them show the same face outwards), or to one on a free edge.
void expect_closed_and_oriented(const Divided& all) {
  const auto sides = sides_of(all.mesh);
  const auto free = free_sides(all);
  std::size_t free_seen = 0;
  for (const auto& [side, times] : sides) {
    EXPECT_EQ(times, 1) << side.first << " to " << side.second;
    EXPECT_NE(side.first, side.second);
    const bool is_free = free.contains(std::minmax(side.first, side.second));
    EXPECT_EQ(sides.contains({side.second, side.first}), !is_free) << side.first << " to " << side.second;
    free_seen += is_free;
  }
  EXPECT_EQ(free_seen, free.size());
}

TEST(GearMesh, HasTheAreaOfItsOutlines) {
  for (const std::size_t nodes : {500u, 2000u, 8000u})
    with_all_gears(by_nodes(nodes), [](const Divided& all) {
      for (std::size_t p = 0; p < all.gear.panels.size(); ++p)
        expect_areas(all.gear.panels[p], all.mesh.panels[p]);
    });
}

TEST(GearMesh, IsWithoutHolesAndShowsOneFaceOutwards) {
  for (const std::size_t nodes : {100u, 500u, 2000u})
    with_all_gears(by_nodes(nodes), expect_closed_and_oriented);
}

TEST(GearMesh, HasAboutAsManyNodesAsAreAskedFor) {
  for (const std::size_t nodes : {500u, 2000u, 8000u})
    with_all_gears(by_nodes(nodes), [&](const Divided& all) {
      EXPECT_NEAR(static_cast<double>(all.mesh.nodes), static_cast<double>(nodes),
                  0.15 * static_cast<double>(nodes));
    });
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
    EXPECT_GT(all.mesh.quality.least_angle, 18 * std::numbers::pi / 180);
    EXPECT_LT(all.mesh.quality.greatest_angle, 140 * std::numbers::pi / 180);
    std::size_t triangles = 0;
    for (const auto& panel : all.mesh.panels) triangles += panel.triangles.size() / 3;
    EXPECT_EQ(all.mesh.quality.triangles, triangles);
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

/// 60 meshes on 56: every node stands at the same share of both edges.
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

/// Where an edge hangs the rope has its nodes, in a row, and as much length as the hanging says.
TEST(GearMesh, RopesRunAlongTheNodesOfTheirEdges) {
  const auto all = divided(library_text("four-panel.toml"), Extent::whole, by_nodes(500));
  EXPECT_EQ(all.rope("headline").nodes, all.nodes("top", "fore"));
  auto breast = all.nodes("starboard-side", "fore");
  std::reverse(breast.begin(), breast.end());  // from the headline's end down to the footrope's
  EXPECT_EQ(all.rope("starboard-breast-line").nodes, breast);
}

/// Wings take 36 of 83.9 ft and the bosom 11.9; what the rope is short of is shared among them.
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

/// Mean length of the sides of triangles where netting is spread.
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
  expect_closed_and_oriented(all);
}

/// A rib rope along a seam has the seam's nodes.
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
  expect_closed_and_oriented(all);
  expect_areas(all.gear.panels[0], all.mesh.panels[0]);
  const auto half = divided(text, Extent::half, by_nodes(300));
  const std::set<std::uint32_t> middle(half.mesh.middle.begin(), half.mesh.middle.end());
  for (const auto node : half.nodes("bag", "sides")) EXPECT_TRUE(middle.contains(node));
}

}  // namespace
}  // namespace netloft::io
