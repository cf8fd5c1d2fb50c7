// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/start.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;
using namespace runs;

namespace {

using formats::test::Input;
using Point = std::array<double, 3>;

/// A rope along x: node 0 held along all axes, node 1 along z, the others free.
class Start : public ::testing::Test {
 protected:
  Start() {
    for (std::uint32_t n = 0; n < 6; ++n) {
      scene.positions.insert(scene.positions.end(), {double(n), 0.5, -2});
      scene.held.push_back(n == 0 ? kAllAxes : n == 1 ? kAxisZ : 0);
    }
    before = scene.positions;
  }
  void spoil_by(const std::string& steps) {
    Input input("start = [" + steps + "]");
    const auto read = read_start(input.reader, 1);
    ASSERT_EQ(input.error(), "");
    spoil(scene, read);
  }
  Point at(std::size_t n) const {
    return {scene.positions[3 * n], scene.positions[3 * n + 1], scene.positions[3 * n + 2]};
  }
  static void expect_near(const Point& a, const Point& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12);
  }

  Scene scene;
  std::vector<double> before;
};

TEST_F(Start, NoiseMovesEveryFreeNodeByNoMoreThanItsAmplitude) {
  spoil_by("{ noise = \"20 mm\" }");
  for (std::size_t d = 6; d < 18; ++d) {
    EXPECT_NE(scene.positions[d], before[d]);
    EXPECT_LE(std::abs(scene.positions[d] - before[d]), 0.02);
  }
}

TEST_F(Start, WhatIsHeldStaysAlongTheAxesOfItsHold) {
  spoil_by("{ noise = 1 }, { scale = 3 }, { turn = \"40 deg\", axis = \"y\" }, { shift = [1, 1, 1] }");
  expect_near(at(0), {0, 0.5, -2});
  EXPECT_EQ(at(1)[2], -2);
  EXPECT_NE(at(1)[0], 1);
}

TEST_F(Start, TheSameSeedGivesTheSameNoiseAndAnotherOneAnother) {
  spoil_by("{ noise = 1, seed = 7 }");
  const auto first = scene.positions;
  scene.positions = before;
  spoil_by("{ noise = 1, seed = 7 }");
  EXPECT_EQ(scene.positions, first);
  scene.positions = before;
  spoil_by("{ noise = 1, seed = 8 }");
  EXPECT_NE(scene.positions, first);
}

TEST_F(Start, ScalesAboutAPoint) {
  spoil_by("{ scale = [2, 0, -1], about = [1, 1, 0] }");
  expect_near(at(4), {7, 1, 2});
}

TEST_F(Start, TurnsByTheRightHandRule) {
  spoil_by("{ turn = \"90 deg\", axis = \"x\" }");
  expect_near(at(4), {4, 2, 0.5});
}

TEST_F(Start, StepsFollowOneAnother) {
  spoil_by("{ shift = [0, 0, 1] }, { scale = [1, 1, 10] }");
  expect_near(at(4), {4, 0.5, -10});
}

TEST_F(Start, ShufflingGivesEveryFreeNodeThePlaceOfAnother) {
  scene.held.assign(6, 0), scene.held[0] = kAllAxes;
  spoil_by("{ shuffle = true, seed = 3 }");
  std::vector<double> x;
  for (std::size_t n = 1; n < 6; ++n) x.push_back(at(n)[0]);
  EXPECT_FALSE(std::is_sorted(x.begin(), x.end()));
  std::sort(x.begin(), x.end());
  EXPECT_EQ(x, (std::vector<double>{1, 2, 3, 4, 5}));
  expect_near(at(0), {0, 0.5, -2});
}

TEST_F(Start, ASliderStaysOnItsLine) {
  // The node is held along x and y of its own axes, and can move along their z axis, (0.6, 0, 0.8).
  scene.held[2] = kAxisX | kAxisY;
  scene.frames[2] = {0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8};
  spoil_by("{ shift = [1, 5, 0] }");
  expect_near(at(2), {2 + 0.36, 0.5, -2 + 0.48});
}

TEST_F(Start, RigidBodiesStay) {
  RigidBody body;
  body.origin = 4, body.points = {{3, {0, 0, 0}}};
  scene.add_body(body);
  spoil_by("{ noise = 1 }");
  for (std::size_t d = 9; d < 15; ++d) EXPECT_EQ(scene.positions[d], before[d]);
  EXPECT_NE(scene.positions[6], before[6]);
}

TEST(StartText, AStepIsOneThing) {
  for (const std::string text : {"start = [{ noise = 1, scale = 2 }]", "start = [{ seed = 1 }]"}) {
    Input input(text);
    read_start(input.reader, 1);
    EXPECT_EQ(input.error(), "1:10: start[0]: one of noise, scale, turn, shift and shuffle is expected");
  }
}

TEST(StartText, SeedsThatAreNotGivenFollowFromTheCase) {
  Input input("start = [{ noise = 1 }, { noise = 1 }, { noise = 1, seed = 4 }]");
  const auto steps = read_start(input.reader, 100);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0].seed, 100u);
  EXPECT_EQ(steps[1].seed, 101u);
  EXPECT_EQ(steps[2].seed, 4u);
}

}  // namespace
}  // namespace netloft::hard_cases
