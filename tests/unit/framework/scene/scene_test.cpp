// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/scene.hpp"

#include <gtest/gtest.h>

#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// Two ropes that have no common node; the first node of the first rope is held.
Sketch two_ropes() {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0), d = s.node(3, 0, 0);
  s.rope("one", {a, b}, 1);
  s.rope("two", {c, d}, 1);
  s.scene.labels = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  return s;
}

TEST(FindLooseParts, FindsAPieceThatNothingHolds) {
  const auto faults = find_loose_parts(two_ropes().scene, {2, 2});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].part, "two");
  EXPECT_EQ(
      faults[0].message,
      "two node 0 is connected to nothing that is held: it would drift away; add a [[hold]] on \"two\" or on "
      "what it is joined to");
}

TEST(FindLooseParts, IsContentWithAPieceThatIsJoinedToAHeldOne) {
  Sketch s = two_ropes();
  s.rope("between", {1, 2}, 1);
  EXPECT_TRUE(find_loose_parts(s.scene, {2, 2, 2}).empty());
}

TEST(FindLooseParts, NamesTheAxesAlongWhichNothingHolds) {
  Sketch s = two_ropes();
  s.scene.held[2] = kAxisY;
  const auto faults = find_loose_parts(s.scene, {2, 2});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].message.find("held along x, z:"), std::string::npos) << faults[0].message;
}

// The piece is held by two supports, neither of which holds all axes.
TEST(FindLooseParts, AddsUpTheAxesOfAPiece) {
  Sketch s = two_ropes();
  s.scene.held[2] = kAxisX | kAxisY;
  s.scene.held[3] = kAxisZ;
  EXPECT_TRUE(find_loose_parts(s.scene, {2, 2}).empty());
}

TEST(FindLooseParts, TellsEachPieceOnce) {
  Sketch s = two_ropes();
  s.scene.held[0] = 0;
  EXPECT_EQ(find_loose_parts(s.scene, {2, 2}).size(), 2u);
}

TEST(Scene, NamesANodeByThePartItWasMadeFor) { EXPECT_EQ(two_ropes().scene.node_name(3), "two node 1"); }

TEST(Current, RunsStraightBetweenSamplesAndConstantBeyond) {
  const Current current{{{-20, {0, 0, 0}}, {-10, {1, 0, 0}}, {0, {2, 3, 0}}}};
  std::array<double, 3> v{}, dz{};
  const auto expect = [&](double z, std::array<double, 3> velocity, std::array<double, 3> slope) {
    current.at(z, v, dz);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_DOUBLE_EQ(v[i], velocity[i]) << "at " << z;
      EXPECT_DOUBLE_EQ(dz[i], slope[i]) << "at " << z;
    }
  };
  expect(-30, {0, 0, 0}, {0, 0, 0});
  expect(-15, {0.5, 0, 0}, {0.1, 0, 0});
  expect(-5, {1.5, 1.5, 0}, {0.1, 0.3, 0});
  expect(5, {2, 3, 0}, {0, 0, 0});
}

TEST(Current, FlowsWhenAnySampleDoes) {
  EXPECT_FALSE(Current{}.flows());
  EXPECT_FALSE((Current{{{-10, {0, 0, 0}}, {0, {0, 0, 0}}}}.flows()));
  EXPECT_TRUE((Current{{{-10, {0, 0, 0}}, {0, {0, 0.1, 0}}}}.flows()));
}

}  // namespace
}  // namespace netloft::test
