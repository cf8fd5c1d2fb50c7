// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/riding.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

ElementType bars() {
  ElementType type;
  type.element.stencil = NETLOFT_BAR;
  return type;
}

/// The node numbers of a rope of bars, and the rest length of each bar [m].
Part rope_of(std::vector<std::uint32_t> nodes, std::vector<double> lengths) {
  Part part;
  part.nodes = std::move(nodes);
  part.data["rest_length"] = std::move(lengths);
  return part;
}

/// A bar of 2 m between the first two of three nodes and one of 4 m between the last two.
Scene two_bars() {
  Scene scene;
  scene.positions.assign(9, 0.0);
  scene.parts.push_back(rope_of({0, 1, 1, 2}, {2, 4}));
  return scene;
}

std::vector<double> carried_by_two_bars(const std::vector<double>& parallel) {
  Scene scene = two_bars();
  if (!parallel.empty()) scene.parts[0].data["parallel"] = parallel;
  const ElementType type = bars();
  const NodeElements elements(scene, {&type});
  std::vector<double> carried;
  for (std::uint32_t node = 0; node < 3; ++node)
    carried.push_back(CarriedLength(scene.parts[0], type).at(elements.at(node, 0)));
  return carried;
}

TEST(Riding, CarriesHalfOfEveryBarOfARope) {
  EXPECT_EQ(carried_by_two_bars({}), (std::vector<double>{1, 3, 2}));
}

TEST(Riding, CarriesAllTwinesThatABarStandsFor) {
  EXPECT_EQ(carried_by_two_bars({2.5, 2.5}), (std::vector<double>{2.5, 7.5, 5}));
}

TEST(Riding, OnBarsAtNodesTakesThoseWithOneEndThere) {
  const Scene scene = two_bars();
  const ElementType type = bars();
  const NodeElements elements(scene, {&type});
  Part at_the_joint, at_two_nodes;
  ride_on_bars_at(scene, 0, elements, {1}, at_the_joint);
  EXPECT_EQ(at_the_joint.nodes, (std::vector<std::uint32_t>{1, 0, 1, 2}));
  EXPECT_EQ(at_the_joint.data["rest_length"], (std::vector<double>{2, 4}));
  ride_on_bars_at(scene, 0, elements, {1, 0}, at_two_nodes);
  EXPECT_EQ(at_two_nodes.nodes, (std::vector<std::uint32_t>{1, 2}));
}

TEST(Riding, OnMeetingBarsTakesEveryPairThatSharesANode) {
  Scene scene = two_bars();
  scene.positions.assign(15, 0.0);
  scene.parts.push_back(rope_of({3, 1, 1, 4}, {8, 16}));
  const ElementType type = bars();
  const NodeElements elements(scene, {&type, &type});
  Part rider;
  ride_on_meeting_bars(scene, 0, 1, elements, rider);
  EXPECT_EQ(rider.nodes, (std::vector<std::uint32_t>{0, 1, 3, 0, 1, 4, 2, 1, 3, 2, 1, 4}));
  EXPECT_EQ(rider.data["rest_length"], (std::vector<double>{2, 8, 2, 16, 4, 8, 4, 16}));
}

TEST(Riding, KnowsNoElementsOfPartsOfUnknownType) {
  Scene scene = two_bars();
  scene.parts.push_back(rope_of({0, 2}, {6}));
  const ElementType type = bars();
  const NodeElements elements(scene, {nullptr, &type});
  EXPECT_TRUE(elements.at(1).empty());
  ASSERT_EQ(elements.at(2).size(), 1u);
  EXPECT_EQ(elements.at(2)[0].part, 1u);
}

}  // namespace
}  // namespace netloft::scenes
