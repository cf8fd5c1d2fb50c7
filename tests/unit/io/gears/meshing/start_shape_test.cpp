// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/start_shape.hpp"

#include "tests/unit/io/gears/plan/plans.hpp"

#include <cmath>

namespace netloft::gears {
namespace {

/// A trawl of the library with some 300 nodes. The plan is a member, because the gear refers to it.
struct Trawl {
  explicit Trawl(Extent extent) : checked(check_text(library_text("83-112-eastern.toml"))) {
    gear = make_gear(checked.plan, extent);
    mesh = divide(gear, {.nodes = 300, .size = 0, .finer = {}});
  }
  double at(const std::vector<double>& x, const std::string& point, std::size_t axis) const {
    return x[3 * std::size_t{mesh.points.at(point)} + axis];
  }

  decltype(check_text(std::string())) checked;
  Gear gear;
  GearMesh mesh;
};

// Only the netting is tested, because bridles lead to a towing point that may be anywhere.
TEST(StartShape, OfAHalfHasItsNettingToStarboardOfItsPlane) {
  const Trawl trawl(Extent::half);
  const auto x = StartShapes(trawl.gear, trawl.mesh).with(trawl.gear);
  for (const auto& panel : trawl.mesh.panels)
    for (const auto node : panel.nodes) EXPECT_GE(x[3 * node + 1], -1e-6) << node;
  for (const auto node : trawl.mesh.middle) EXPECT_NEAR(x[3 * node + 1], 0, 1e-6) << node;
}

TEST(StartShape, OfTheWholeIsSymmetric) {
  const Trawl trawl(Extent::whole);
  const auto x = StartShapes(trawl.gear, trawl.mesh).with(trawl.gear);
  EXPECT_NEAR(trawl.at(x, "headrope.start", 1), -trawl.at(x, "headrope.end", 1),
              0.05 * trawl.at(x, "headrope.end", 1));
  EXPECT_GT(trawl.at(x, "headrope.end", 1), 2);
}

TEST(StartShape, HasTheHeadropeAboveTheFootropeAndTheCodendAft) {
  const Trawl trawl(Extent::half);
  const auto x = StartShapes(trawl.gear, trawl.mesh).with(trawl.gear);
  EXPECT_GT(trawl.at(x, "headrope.start", 2), trawl.at(x, "footrope.start", 2) + 1);
  EXPECT_GT(trawl.at(x, "top-codend.aft-outer", 0), trawl.at(x, "headrope.start", 0) + 20);
}

TEST(StartShape, PutsEveryKnownCoordinateInItsPlaceAndLeadsBridlesStraight) {
  const Trawl trawl(Extent::half);
  const auto towed = trawl.mesh.points.at("towing-point"), tip = trawl.mesh.points.at("headrope.end");
  const auto x =
      StartShapes(trawl.gear, trawl.mesh)
          .with(trawl.gear, {{towed, 0, -60.0}, {towed, 1, 9.0}, {towed, 2, -20.0}, {tip, 1, 8.75}});
  EXPECT_NEAR(trawl.at(x, "towing-point", 0), -60, 1e-6);
  EXPECT_NEAR(trawl.at(x, "towing-point", 2), -20, 1e-6);
  EXPECT_NEAR(trawl.at(x, "headrope.end", 1), 8.75, 1e-6);
  const double bridle =
      std::hypot(trawl.at(x, "headrope.end", 0) + 60, 8.75 - 9.0, trawl.at(x, "headrope.end", 2) + 20);
  EXPECT_NEAR(bridle, 54.9, 1.5);
}

TEST(StartShape, StretchesNoSideOfATriangleFarBeyondItsTwines) {
  const Trawl trawl(Extent::half);
  const auto x = StartShapes(trawl.gear, trawl.mesh).with(trawl.gear);
  for (std::size_t p = 0; p < trawl.mesh.panels.size(); ++p) {
    const PanelMesh& panel = trawl.mesh.panels[p];
    for (std::size_t i = 0; i < panel.triangles.size(); ++i) {
      const auto a = panel.triangles[i], b = panel.triangles[i % 3 == 2 ? i - 2 : i + 1];
      const double across = panel.meshes[b][0] - panel.meshes[a][0],
                   deep = panel.meshes[b][1] - panel.meshes[a][1];
      const double twines = std::max(std::abs(across), std::abs(deep)) * trawl.gear.panels[p].panel->mesh;
      double square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        square += std::pow(x[3 * panel.nodes[b] + axis] - x[3 * panel.nodes[a] + axis], 2);
      EXPECT_LT(std::sqrt(square), 1.6 * twines + 0.3) << trawl.gear.panels[p].name << " side " << i;
    }
  }
}

/// Netting of 96 meshes around and 24 deep, open at both ends, made of one panel or of several.
std::string tube_in(const std::string& pieces) {
  const auto panel = [](const char* name, const std::string& more) {
    return "[panels." + std::string(name) +
           "]\nmesh = \"40 mm\"\ntwine = { diameter = \"1 mm\", EA = \"3 kN\", density = 960 }\ndepth = "
           "24\n" +
           "open = [\"fore\", \"aft\"]\n" + more;
  };
  const auto seam = [](const std::string& one, const std::string& other) {
    return "[[join]]\nedges = [\"" + one + "\", \"" + other + "\"]\n";
  };
  const std::string pair = "stands = \"pair\"\nouter = \"AN\"\ninner = \"AN\"\n";
  if (pieces == "one") return panel("tube", "round = 96\n");
  if (pieces == "upper and lower")
    return panel("upper", "fore = 48\nsides = \"AN\"\n") + panel("lower", "fore = 48\nsides = \"AN\"\n") +
           seam("upper.sides", "lower.sides");
  if (pieces == "two sides")
    return panel("side", pair + "fore = 48\n") + seam("side.inner", "side.inner") +
           seam("side.outer", "side.outer");
  return panel("upper", pair + "fore = 24\n") + panel("lower", pair + "fore = 24\n") +
         seam("upper.inner", "upper.inner") + seam("lower.inner", "lower.inner") +
         seam("upper.outer", "lower.outer");
}

/// The least and greatest coordinates of the initial shape: y, then z.
std::array<double, 4> extent_of_start(const std::string& pieces, Extent extent) {
  const auto checked = check_text(tube_in(pieces));
  EXPECT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const Gear gear = make_gear(checked.plan, extent);
  const GearMesh mesh = divide(gear, {.nodes = extent == Extent::half ? 300u : 600u, .finer = {}});
  const auto x = StartShapes(gear, mesh).with(gear);
  std::array<double, 4> box{0, 0, 0, 0};
  for (std::size_t node = 0; node < mesh.nodes; ++node)
    for (const std::size_t axis : {1u, 2u}) {
      box[2 * axis - 2] = std::min(box[2 * axis - 2], x[3 * node + axis]);
      box[2 * axis - 1] = std::max(box[2 * axis - 1], x[3 * node + axis]);
    }
  return box;
}

// Half the girth has 48 meshes, each sin(pi/8) of 40 mm wide. It is half the perimeter (by Ramanujan) of an
// ellipse whose height is 0.4 of its width, so that the semi-axes are 0.319 m and 0.128 m.
TEST(StartShape, OfATubeIsTheSameRingWhateverPiecesItIsSewnOf) {
  for (const char* pieces : {"one", "upper and lower", "two sides", "four pieces"}) {
    SCOPED_TRACE(pieces);
    const auto whole = extent_of_start(pieces, Extent::whole), half = extent_of_start(pieces, Extent::half);
    EXPECT_NEAR(whole[1] - whole[0], 2 * 0.319, 0.01);
    EXPECT_NEAR(whole[3] - whole[2], 2 * 0.128, 0.004);
    EXPECT_NEAR(half[0], 0, 1e-6);
    EXPECT_NEAR(half[1], 0.319, 0.005);
    EXPECT_NEAR(half[3] - half[2], 2 * 0.128, 0.004);
  }
}

}  // namespace
}  // namespace netloft::gears
