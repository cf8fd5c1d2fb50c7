// SPDX-License-Identifier: BSD-3-Clause
//
// Drag and buoyancy that ropes lose above the surface, computed by hand: surface.hpp (1)–(3) on bars.
#include "plugins/rope/bar.hpp"
#include "tests/unit/plugins/kernel_oracle.hpp"

#include <numbers>

namespace {

using namespace netloft;
using rope::Bar;

constexpr Water kWater{1000, 10};
constexpr double kLength = 2, kDiameter = 0.1;
const double kVolume = std::numbers::pi / 4 * kDiameter * kDiameter * kLength, kSide = std::cbrt(kVolume / 2);

Bar::Parameters rope_with(double surface) {
  Bar::Parameters p;
  p.EA = 1e5, p.diameter = kDiameter, p.density = 500, p.surface = surface;
  return p;
}

/// A level bar of which one end is at height z and the other far below.
struct OneEndAt {
  OneEndAt(double surface, double z) : parameters(rope_with(surface)), tile(kWater) {
    family = make_family<Bar>(parameters, {{kLength}});
    tile.t.count = 1;
    tile.x[2 * kLanes] = z, tile.x[3 * kLanes] = kLength, tile.x[5 * kLanes] = -50;
    tile.want_tangent();
    Bar::DryBuoyancy::tile(family, tile.t);
  }
  Bar::Parameters parameters;
  Family<Bar> family;
  TestTile<2> tile;
  double lost_lift() const { return tile.force[2 * kLanes]; }
  double stiffness() const { return tile.tangent[5 * kLanes]; }  // vertical force by vertical displacement
};

const double kLift = kVolume / 2 * 1000 * 10;

TEST(Surface, TakesNoBuoyancyOfWhatIsImmersed) {
  const OneEndAt end(1, -0.6 * kSide);
  EXPECT_EQ(end.lost_lift(), 0);
  EXPECT_EQ(end.stiffness(), 0);
}

TEST(Surface, TakesHalfOfTheBuoyancyAtTheSurface) {
  const OneEndAt end(1, 0);
  EXPECT_NEAR(end.lost_lift(), 0.5 * kLift, 1e-9);
  EXPECT_NEAR(end.stiffness(), kLift / kSide, 1e-6);
}

TEST(Surface, TakesAllBuoyancyAboveIt) {
  const OneEndAt end(1, 0.7 * kSide);
  EXPECT_NEAR(end.lost_lift(), kLift, 1e-9);
  EXPECT_EQ(end.stiffness(), 0);
  EXPECT_EQ(end.tile.force[5 * kLanes], 0);  // the other end is deep
}

TEST(Surface, IsNotThereWithoutBeingAskedFor) { EXPECT_EQ(OneEndAt(0, 3).lost_lift(), 0); }

TEST(Surface, HasAnEnergyWhoseSlopeIsWhatIsLost) {
  const double h = 1e-5 * kSide, z = 0.2 * kSide;
  const double slope = (OneEndAt(1, z + h).tile.energy[0] - OneEndAt(1, z - h).tile.energy[0]) / (2 * h);
  EXPECT_NEAR(slope, OneEndAt(1, z).lost_lift(), 1e-6 * kLift);
  EXPECT_NEAR(OneEndAt(1, 3).tile.energy[0], kLift * 3, 1e-9);  // lifted out and 3 m higher
}

/// A law that pushes every metre with 8 N along x.
int push_with_eight(const void*, const netloft_law_tile* f) {
  for (std::size_t i = 0; i < f->count; ++i) {
    f->force[i] = 8, f->force[kLanes + i] = f->force[2 * kLanes + i] = 0;
    for (std::size_t k = 0; f->d_flow && k < 9; ++k)
      f->d_flow[k * kLanes + i] = f->d_direction[k * kLanes + i] = 0;
    for (std::size_t k = 0; f->d_solidity && k < 3; ++k) f->d_solidity[k * kLanes + i] = 0;
  }
  return NETLOFT_OK;
}

TEST(Surface, TakesTheDragOfEachEndByItsOwnWetness) {
  const Bar::Parameters p = rope_with(1);
  Family<Bar> family = make_family<Bar>(p, {{kLength}});
  family.laws_ = {{NETLOFT_TWINE_LAW, 0, nullptr, &push_with_eight}};
  TestTile<2> tile(kWater);
  tile.t.count = 1;
  tile.x[2 * kLanes] = 0.25 * kSide, tile.x[3 * kLanes] = kLength, tile.x[5 * kLanes] = -0.25 * kSide;
  ASSERT_EQ(Bar::DryDrag::tile(family, tile.t), Status::ok);
  EXPECT_NEAR(tile.force[0], 0.75 * 8, 1e-12);  // half of 2 m; three quarters of the cube are dry
  EXPECT_NEAR(tile.force[3 * kLanes], 0.25 * 8, 1e-12);
}

}  // namespace
