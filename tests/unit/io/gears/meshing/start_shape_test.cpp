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

}  // namespace
}  // namespace netloft::gears
