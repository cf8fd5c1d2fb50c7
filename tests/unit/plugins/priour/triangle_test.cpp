// SPDX-License-Identifier: BSD-3-Clause
//
// The terms of priour/triangle compared with their energies differentiated by dual numbers, and with values
// by hand.
#include "plugins/priour/triangle.hpp"

#include "tests/unit/plugins/priour/panels.hpp"

namespace {

using namespace netloft;
using priour::Triangle;

const Triangle::Parameters kTwine{1e4, 1, 0.004, 1140};

/// Places corners so that the bars of both directions have a length of about `stretch` x 0.1 m.
void place_stretched_corners(TestTile<3>& tile, const std::vector<Triangle::Data>& data, double stretch) {
  std::mt19937_64 random(3);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    Vec3<double> U{1, 0, 0}, V{0, 1, 0};
    for (int axis = 0; axis < 3; ++axis)
      U[axis] += uniform(random, -0.2, 0.2), V[axis] += uniform(random, -0.2, 0.2);
    U = (0.1 * stretch / norm(U)) * U, V = (0.1 * stretch / norm(V)) * V;
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        tile.x[(3 * corner + static_cast<std::size_t>(axis)) * kLanes + lane] =
            data[lane].u[corner] * U[axis] + data[lane].v[corner] * V[axis];
  }
}

void expect_elastic_matches(double stretch) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  place_stretched_corners(tile, data, stretch);
  expect_kernel_matches_oracle<Triangle, Triangle::Elastic>(kTwine, data, kSeaWater, tile, false);
}

TEST(PriourTriangle, MatchesItsOracleWhenTaut) { expect_elastic_matches(1.3); }

TEST(PriourTriangle, MatchesItsOracleWhenSlack) { expect_elastic_matches(0.4); }

TEST(PriourTriangle, WeighsAsMuchAsTheTwinesInIt) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  const auto family = make_family<Triangle>(kTwine, data);
  ASSERT_EQ(Triangle::Weight::tile(family, tile.t), Status::ok);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto &u = data[lane].u, &v = data[lane].v;
    const double d = std::abs((u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]));
    const double section = 3.14159265358979324 / 4 * 0.004 * 0.004;
    const double third = d * section * 0.1 * (1140 - 1025) * 9.81 / 3;  // equation (7)
    for (std::size_t corner = 0; corner < 3; ++corner)
      EXPECT_NEAR(tile.force[(3 * corner + 2) * kLanes + lane], third, 1e-12 * third) << lane;
  }
}

TEST(PriourTriangle, DoubleNettingPullsAndWeighsTwice) {
  const auto data = panels();
  Triangle::Parameters twice = kTwine;
  twice.number = 2;
  const auto single = make_family<Triangle>(kTwine, data), both = make_family<Triangle>(twice, data);
  TestTile<3> one(kSeaWater), two(kSeaWater);
  place_stretched_corners(one, data, 1.1), place_stretched_corners(two, data, 1.1);
  Triangle::Elastic::tile(single, one.t), Triangle::Elastic::tile(both, two.t);
  Triangle::Weight::tile(single, one.t), Triangle::Weight::tile(both, two.t);
  for (std::size_t i = 0; i < 9 * kLanes; ++i) EXPECT_DOUBLE_EQ(two.force[i], 2 * one.force[i]) << i;
}

TEST(PriourTriangle, FindsBarsAndAngleOfAPanelStretchedOnAFrame) {
  const Triangle::Data data{{0, 10, 0}, {0, 0, 10}, 0.1};
  State<3> s;  // twines along (3, 4, 0)/5 and (3, -4, 0)/5, each bar 0.15 m
  s.x[1] = {0.9, 1.2, 0};
  s.x[2] = {0.9, -1.2, 0};
  EXPECT_NEAR(Triangle::stretch(0, kTwine, data, s).l, 0.15, 1e-15);
  EXPECT_NEAR(Triangle::stretch(1, kTwine, data, s).T, 1e4 * 0.5, 1e-9);
  EXPECT_NEAR(Triangle::half_angle(data, s), std::atan2(4, 3), 1e-15);
}

TEST(PriourTriangle, RefusesCornersOnALineAndBarsWithoutLength) {
  EXPECT_THROW(Triangle::check(kTwine, {{0, 1, 2}, {0, 1, 2}, 0.1}), std::invalid_argument);
  EXPECT_THROW(Triangle::check(kTwine, {{0, 1, 0}, {0, 0, 1}, 0.0}), std::invalid_argument);
  EXPECT_NO_THROW(Triangle::check(kTwine, {{0, 1, 0}, {0, 0, 1}, 0.1}));
}

}  // namespace
