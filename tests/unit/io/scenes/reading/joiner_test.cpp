// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/joiner.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

using Nodes = std::vector<std::uint32_t>;

/// A rope with n nodes at x = first, first + 1, …
Geometry rope(std::uint32_t n, double first) {
  Geometry g;
  for (std::uint32_t i = 0; i < n; ++i) {
    g.positions.insert(g.positions.end(), {first + i, 0, 0});
    if (i > 0) g.elements.insert(g.elements.end(), {i - 1, i});
  }
  return g;
}

class Join : public testing::Test {
 protected:
  std::vector<Geometry> parts{rope(3, 0), rope(3, 10), rope(2, 20)};
  Joiner joiner{parts};
  const std::vector<int> two{2, 2, 2};

  Scene number() {
    Scene scene;
    joiner.number(scene);
    return scene;
  }
};

TEST_F(Join, NumbersNodesPartByPart) {
  const Scene scene = number();
  EXPECT_EQ(scene.node_count(), 8u);
  EXPECT_EQ(joiner.nodes(0), (Nodes{0, 1, 2}));
  EXPECT_EQ(joiner.nodes(1), (Nodes{3, 4, 5}));
  EXPECT_EQ(scene.positions[3 * 3], 10);
  EXPECT_EQ(scene.labels[4].part, 1u);
  EXPECT_EQ(scene.labels[4].id, 1u);
}

TEST_F(Join, MakesOneNodeAtThePlaceOfTheFirst) {
  joiner.join({{0, {2}}, {1, {0}}});
  const Scene scene = number();
  EXPECT_EQ(scene.node_count(), 7u);
  EXPECT_EQ(joiner.nodes(1), (Nodes{2, 3, 4}));
  EXPECT_EQ(scene.positions[3 * 2], 2);
  EXPECT_EQ(scene.labels[2].part, 0u);
}

TEST_F(Join, TakesThePlaceOfTheFirstPartWhateverTheOrderOfWriting) {
  joiner.join({{1, {0}}, {0, {2}}});
  EXPECT_EQ(number().positions[3 * 2], 2);
}

TEST_F(Join, PairsEdgesNodeByNode) {
  joiner.join({{0, {0, 1, 2}}, {1, {2, 1, 0}}});
  number();
  EXPECT_EQ(joiner.nodes(1), (Nodes{2, 1, 0}));
}

TEST_F(Join, JoinsThreeInOnePoint) {
  joiner.join({{0, {2}}, {1, {0}}, {2, {1}}});
  EXPECT_EQ(number().node_count(), 6u);
  EXPECT_EQ(joiner.nodes(2)[1], joiner.nodes(0)[2]);
}

TEST_F(Join, DoesNotDependOnTheOrderOfJoins) {
  Joiner other(parts);
  const Joiner::Ends a{0, {2}}, b{1, {0}}, c{2, {1}};
  joiner.join({a, b});
  joiner.join({b, c});
  other.join({c, b});
  other.join({b, a});
  number();
  Scene scene;
  other.number(scene);
  for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(joiner.nodes(p), other.nodes(p));
}

TEST_F(Join, ClosesARopeToARing) {
  joiner.join({{0, {0}}, {0, {2}}});
  EXPECT_FALSE(joiner.find_collapse(two));
  EXPECT_EQ(number().node_count(), 7u);
  EXPECT_EQ(joiner.nodes(0), (Nodes{0, 1, 0}));
}

TEST_F(Join, FindsTheBarWhoseEndsBecameOne) {
  joiner.join({{0, {1}}, {0, {2}}});
  const auto fault = joiner.find_collapse(two);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->part, 0u);
  EXPECT_EQ(fault->element, 1u);
}

TEST_F(Join, FindsABarThatCollapsesRoundACorner) {
  joiner.join({{2, {0}}, {0, {0}}});
  joiner.join({{2, {1}}, {1, {0}}});
  EXPECT_FALSE(joiner.find_collapse(two));
  joiner.join({{0, {0}}, {1, {0}}});
  EXPECT_EQ(joiner.find_collapse(two)->part, 2u);
}

TEST_F(Join, GathersAllNodesInTheirMiddle) {
  joiner.gather({{0, {0, 1}}, {1, {0}}});
  const Scene scene = number();
  EXPECT_EQ(joiner.nodes(0)[0], joiner.nodes(0)[1]);
  EXPECT_EQ(joiner.nodes(1)[0], joiner.nodes(0)[0]);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_DOUBLE_EQ(
        scene.positions[3 * joiner.nodes(0)[0] + axis],
        (parts[0].positions[axis] + parts[0].positions[3 + axis] + parts[1].positions[axis]) / 3);
}

TEST_F(Join, FindsTheBarThatWasGathered) {
  joiner.gather({{0, {0, 1}}});
  EXPECT_EQ(joiner.find_collapse(two)->element, 0u);
}

/// Two triangles on the nodes of a square.
std::vector<Geometry> square() {
  std::vector<Geometry> parts(1);
  parts[0].positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  parts[0].elements = {0, 1, 2, 0, 2, 3};
  return parts;
}

TEST(Gathered, NettingMayEndInAPointButNotBeOne) {
  const auto parts = square();
  Joiner edge(parts), all(parts), joined(parts);
  edge.gather({{0, {2, 3}}});
  EXPECT_FALSE(edge.find_collapse({3}));
  all.gather({{0, {1, 2, 3}}});
  EXPECT_FALSE(all.find_collapse({3}));
  all.gather({{0, {0, 1}}});
  EXPECT_TRUE(all.find_collapse({3}));
  joined.join({{0, {2}}, {0, {3}}});
  EXPECT_EQ(joined.find_collapse({3})->element, 1u);
}

}  // namespace
}  // namespace netloft::scenes
