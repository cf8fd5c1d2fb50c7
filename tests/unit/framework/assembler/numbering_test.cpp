// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/numbering.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framework/assembler/matrix_size.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

TEST(Numbering, PutsUnknownsFirstInTheOrderOfTheNodes) {
  Sketch s;
  s.node(0, 0, 0, kAllAxes);
  s.node(1, 0, 0, kAxisY);
  s.node(2, 0, 0);
  const Numbering n(s.scene);
  EXPECT_EQ(n.unknowns(), 5);
  EXPECT_EQ(n.dofs(), 9u);
  EXPECT_EQ(n.dof(1, 0), Dof(0));
  EXPECT_EQ(n.dof(1, 2), Dof(1));
  EXPECT_EQ(n.dof(2, 0), Dof(2));
  EXPECT_EQ(n.dof(2, 2), Dof(4));
  EXPECT_EQ(n.dof(0, 0), Dof(5));
  EXPECT_EQ(n.dof(0, 2), Dof(7));
  EXPECT_EQ(n.dof(1, 1), Dof(8));
}

TEST(Numbering, FindsNodeAndAxisOfEveryPlace) {
  Sketch s;
  for (const int held : {7, 0, 2, 5, 0}) s.node(0, 0, 0, static_cast<std::uint8_t>(held));
  const Numbering n(s.scene);
  for (std::uint32_t node = 0; node < 5; ++node)
    for (int axis = 0; axis < 3; ++axis) {
      const auto place = n.dof(node, axis);
      EXPECT_EQ(n.node(place), node);
      EXPECT_EQ(n.axis(place), axis);
      EXPECT_EQ(n.is_unknown(place), !(s.scene.held[node] & (1 << axis)));
    }
}

TEST(NodePositions, AreThoseOfTheSceneAgain) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0.5, 0, kAxisY), c = s.node(2, 0, -3);
  s.rope("rope", {a, b, c}, 1);
  const Assembled scene(s.scene);
  EXPECT_EQ(scene.assembler.node_positions(scene.assembler.start()), s.scene.positions);
  EXPECT_EQ(scene.assembler.node_position(c, scene.assembler.start()), (std::array<double, 3>{2, 0, -3}));
}

TEST(Pattern, HoldsTheLowerTriangleOfNeighbours) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0), d = s.node(3, 0, 0);
  s.rope("rope", {a, b, c, d}, 1);
  const Assembled scene(s.scene);
  const SparsePattern& p = scene.assembler.pattern();
  EXPECT_TRUE(p.symmetric);
  EXPECT_EQ(p.size, 9);
  // Entries of the lower triangle: 6 of b and 9 of b with c, 6 of c and 9 of c with d, 6 of d. There are none
  // of b with d.
  EXPECT_EQ(p.entries(), 15u + 15u + 6u);
  EXPECT_EQ(p.column_start.back(), 36);
  for (std::int32_t column = 0; column < p.size; ++column) {
    const auto begin = p.column_start[static_cast<std::size_t>(column)];
    EXPECT_EQ(p.row[static_cast<std::size_t>(begin)], column) << "the diagonal comes first";
    for (auto k = begin + 1; k < p.column_start[static_cast<std::size_t>(column) + 1]; ++k)
      EXPECT_LT(p.row[static_cast<std::size_t>(k) - 1], p.row[static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(p.node, (std::vector<std::int32_t>{1, 1, 1, 2, 2, 2, 3, 3, 3}));
}

TEST(Pattern, IsWholeWhenATermIsUnsymmetric) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0);
  s.rope("rope", {a, b, c}, 1);
  s.part("push", "test/follower", {{"k", 1.0}}, {b, c}).data["rest_length"] = {1};
  const Assembled scene(s.scene);
  const SparsePattern& p = scene.assembler.pattern();
  EXPECT_FALSE(p.symmetric);
  EXPECT_EQ(p.entries(), 36u);
  EXPECT_EQ(scene.plan.unsymmetric_because, "test/follower push");
}

TEST(Pattern, HasADiagonalForNodesThatNoElementTouches) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0);
  s.node(5, 0, 0, kAxisX);
  s.rope("rope", {a, b}, 1);
  const Assembled scene(s.scene);
  const SparsePattern& p = scene.assembler.pattern();
  EXPECT_EQ(p.size, 5);
  EXPECT_EQ(p.entries(), 6u + 3u);
}

TEST(Pattern, HasASlotOfItsOwnForEveryEntry) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAxisY), b = s.node(1, 0, 0), c = s.node(2, 0, 0, kAxisX | kAxisZ);
  s.rope("rope", {a, b, c}, 1);
  const Assembled scene(s.scene);
  const SparsePattern& p = scene.assembler.pattern();
  std::vector<bool> taken(scene.assembler.value_slots());
  for (std::size_t k = 0; k < p.entries(); ++k) {
    ASSERT_LT(p.slot_of(k), p.value_slots());
    EXPECT_FALSE(taken[p.slot_of(k)]);
    taken[p.slot_of(k)] = true;
  }
}

TEST(Pattern, IsRefusedWhereItHasMoreValuesThan32BitsCount) {
  EXPECT_NO_THROW(require_indices(238'609'294));  // 2³¹ / 9, rounded down
  EXPECT_THROW(require_indices(238'609'295), std::length_error);
}

}  // namespace
}  // namespace netloft::test
