// SPDX-License-Identifier: BSD-3-Clause
//
// Unknowns that all elements of a part share, and that are solved for together with the positions.
#include <gtest/gtest.h>

#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// A part of 70 bars of 1 m, more than a tile, whose rest length is an unknown, and a part of two bars of 3 m
/// with a given rest length.
Scene two_parts() {
  Sketch s;
  std::vector<std::uint32_t> many, few;
  for (int i = 0; i < 70; ++i) {
    const auto a = s.node(i, 0, 0), b = s.node(i, 1, 0, kAxisZ);
    many.insert(many.end(), {a, b});
  }
  for (int i = 0; i < 2; ++i) {
    const auto a = s.node(i, 0, 5), b = s.node(i, 3, 5);
    few.insert(few.end(), {a, b});
  }
  s.part("many", "test/alike", {{"k", 2.0}, {"free", 1.0}}, many).data["rest_length"].assign(70, 1);
  s.part("few", "test/alike", {{"k", 2.0}}, few).data["rest_length"].assign(2, 1);
  return s.scene;
}

std::uint32_t shared_node(const Assembled& a, std::size_t part) {
  return a.assembler.families()[0]->global_nodes().at(part).node;
}
std::size_t shared(const Assembled& a, std::size_t part) {
  return a.assembler.numbering().dof(shared_node(a, part), 0).at();
}

TEST(Globals, AreUnknownsWhereTheirPartSaysSo) {
  const Assembled a(two_parts());
  const Numbering& numbering = a.assembler.numbering();
  EXPECT_EQ(a.plan.unknowns, 3 * 144u - 70 + 1);
  EXPECT_EQ(static_cast<std::size_t>(numbering.unknowns()), a.plan.unknowns);
  EXPECT_TRUE(numbering.is_unknown(Dof(shared(a, 0))));
  EXPECT_FALSE(numbering.is_unknown(Dof(shared(a, 1))));
  EXPECT_EQ(a.plan.families[0].globals.size(), 1u);
}

TEST(Globals, StartWhereTheElementsOfTheirPartSay) {
  const Assembled a(two_parts());
  EXPECT_EQ(a.assembler.start()[shared(a, 0)], 140);
  EXPECT_EQ(a.assembler.start()[shared(a, 1)], 4);
}

TEST(Globals, HaveAnEquationThatAllElementsOfThePartAddTo) {
  Assembled a(two_parts());
  auto x = a.assembler.start();
  x[shared(a, 0)] = 1.5;
  const auto r = a.residual(x);
  EXPECT_NEAR(r[shared(a, 0)], -70 * 2 * (1 - 1.5), 1e-12);  // −Σ k (‖w‖² − q)
  EXPECT_NEAR(a.energy(x), 70 * 0.25 + 2 * 25, 1e-12);
}

TEST(Globals, HaveTheirRowAndColumnInTheTangent) {
  Assembled a(two_parts());
  auto x = a.moved(0.1);
  EXPECT_LT(largest_difference(a.matrix(x, MatrixKind::exact), difference(a, x, 1e-5)), 1e-5);
}

TEST(Globals, AreTheSameForAnyNumberOfThreads) {
  Assembled one(two_parts()), two(two_parts(), 2);
  const auto x = one.moved(0.1);
  EXPECT_EQ(one.residual(x), two.residual(x));
  EXPECT_EQ(one.matrix(x, MatrixKind::exact), two.matrix(x, MatrixKind::exact));
}

TEST(Globals, AreNamedByTheirPart) {
  const Assembled a(two_parts());
  EXPECT_EQ(a.assembler.node_name(a.scene, shared_node(a, 0)), "many square");
  EXPECT_EQ(a.assembler.node_name(a.scene, shared_node(a, 1)), "few square");
  EXPECT_EQ(a.assembler.node_name(a.scene, 3), a.scene.node_name(3));
}

TEST(Globals, WantTheWholeTangent) {
  EXPECT_THROW(make_scene_plan(two_parts(), plugins(), TangentChoice::elastic), SceneError);
  EXPECT_THROW(make_scene_plan(two_parts(), plugins(), TangentChoice::symmetric), SceneError);
}

}  // namespace
}  // namespace netloft::test
