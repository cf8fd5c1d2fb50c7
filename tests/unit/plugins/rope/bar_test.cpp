// SPDX-License-Identifier: BSD-3-Clause
//
// The terms of rope/bar compared with their energies differentiated by dual numbers, and with values by hand.
#include "plugins/rope/bar.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

namespace {

using namespace netloft;
using rope::Bar;

const Bar::Parameters kRope{1e5, 1e2, 0.02, 1400};

/// Bars 1 m long at rest, in any direction, with lengths between `least` and `most`.
void place_bars(TestTile<2>& tile, double least, double most) {
  std::mt19937_64 random(1);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Vec3<double> d{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)};
    const double scale = uniform(random, least, most) / norm(d);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      tile.x[a * kLanes + lane] = uniform(random, -1, 1);
      tile.x[(a + 3) * kLanes + lane] = tile.x[a * kLanes + lane] + scale * d[axis];
    }
  }
}

const std::vector<Bar::Data> kOneMetre(kLanes, Bar::Data{1.0});

TEST(RopeBar, MatchesItsOracleWhenTaut) {
  TestTile<2> tile(kSeaWater);
  place_bars(tile, 1.1, 2);
  expect_kernel_matches_oracle<Bar, Bar::Elastic>(kRope, kOneMetre, kSeaWater, tile, false);
}

TEST(RopeBar, MatchesItsOracleWhenSlack) {
  TestTile<2> tile(kSeaWater);
  place_bars(tile, 0.1, 0.9);
  expect_kernel_matches_oracle<Bar, Bar::Elastic>(kRope, kOneMetre, kSeaWater, tile, false);
}

TEST(RopeBar, WeighsWhatItsOracleSays) {
  TestTile<2> tile(kSeaWater);
  place_bars(tile, 0.5, 2);
  expect_kernel_matches_oracle<Bar, Bar::Weight>(kRope, kOneMetre, kSeaWater, tile, true);
}

TEST(RopeBar, WeighsWhatAMetreOfItIsSaidToWeighInTheWater) {
  Bar::Parameters p = kRope;
  for (const double w : {28.0, -3.5}) {
    p.weight_in_water = w;
    TestTile<2> tile(kSeaWater);
    place_bars(tile, 0.5, 2);
    expect_kernel_matches_oracle<Bar, Bar::Weight>(p, kOneMetre, kSeaWater, tile, true);
    EXPECT_NEAR(tile.force[2 * kLanes] + tile.force[5 * kLanes], w, 1e-12);
  }
  p.diameter = 0;
  EXPECT_THROW(Bar::check(p, {1}), std::invalid_argument);
}

TEST(RopeBar, PullsItsEndsTogetherWhenStretchedByTenPercent) {
  TestTile<2> tile(kSeaWater);
  for (std::size_t lane = 0; lane < kLanes; ++lane) tile.x[3 * kLanes + lane] = 1.1;
  const auto family = make_family<Bar>(kRope, kOneMetre);
  ASSERT_EQ(Bar::Elastic::tile(family, tile.t), Status::ok);
  EXPECT_NEAR(tile.force[0], -1e4, 1e-8);          // residual: minus the pull towards node 1
  EXPECT_NEAR(tile.force[3 * kLanes], 1e4, 1e-8);  // EA (l/l0 - 1) = 1e5 N x 0.1
  EXPECT_NEAR(tile.energy[0], 500, 1e-9);          // T (l - l0) / 2
}

TEST(RopeBar, RefusesARestLengthThatIsNotPositive) {
  for (const double length : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(Bar::check(kRope, {length}), std::invalid_argument) << length;
}

}  // namespace
