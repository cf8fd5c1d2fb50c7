// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/frames.hpp"

#include "tests/support/sample_scenes.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

/// The axes of a node's unknowns, with d = (1, 0, -1)/√2.
std::array<double, 9> inclined_axes() {
  const double c = std::sqrt(0.5);
  return {c, 0, c, 0, 1, 0, -c, 0, c};
}

/// A bar from the origin to a bead that moves on the line along (1, 0, -1) and starts at a distance of 1.2 m.
Scene bead_on_a_line() {
  Scene scene = sample::hanging_rope(1);
  scene.parts[0].data["rest_length"] = {1.0};
  scene.parts[0].parameters = {{"rope.EA", 1000.0}, {"rope.diameter", 0.02}, {"rope.density", 7850.0}};
  scene.positions = {0, 0, 0, 1.2 * std::sqrt(0.5), 0, -1.2 * std::sqrt(0.5)};
  scene.frames[1] = inclined_axes();
  scene.held = {kAllAxes, kAxisY | kAxisZ};
  return scene;
}

TEST(Frames, LetABeadSlideToWhereTheRopeCarriesItsWeightAlongTheLine) {
  const auto solved = test::solve(bead_on_a_line());
  const double half_weight = 0.5 * M_PI / 4 * 0.02 * 0.02 * (7850 - 1025) * 9.81;
  const double s = 1 + half_weight * std::sqrt(0.5) / 1000;  // EA (s - 1) = (W/2) sin 45°
  EXPECT_EQ(solved.solution.status, SolveStatus::converged);
  EXPECT_NEAR(solved.position(1)[0], s * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(solved.position(1)[2], -s * std::sqrt(0.5), 1e-12);
}

TEST(Frames, GiveTheReactionOfALineAcrossItInWorldAxes) {
  const auto solved = test::solve(bead_on_a_line());
  const double half_weight = 0.5 * M_PI / 4 * 0.02 * 0.02 * (7850 - 1025) * 9.81;
  const auto r = solved.assembler->reaction(1, solved.solution.residual);
  EXPECT_NEAR(r[0], half_weight / 2, 1e-9);  // (W/2) cos 45° along (1, 0, 1)/√2
  EXPECT_NEAR(r[1], 0, 1e-12);
  EXPECT_NEAR(r[2], half_weight / 2, 1e-9);
}

TEST(Frames, KeepTheTangentTheDerivativeOfTheResidual) {
  Scene scene = sample::hanging_panel(2, 54);
  scene.frames[4] = inclined_axes(), scene.held[4] = kAxisX;
  scene.frames[5] = inclined_axes(), scene.held[5] = kAxisY | kAxisZ;
  ScenePlan plan = make_scene_plan(scene, test::shipped_plugins());
  Assembler assembler(scene, plan, 1);
  const SparsePattern& pattern = assembler.pattern();
  const auto n = static_cast<std::size_t>(pattern.size);
  std::vector<double> u(n, 0.0), x(assembler.start()), values(assembler.value_slots());
  std::vector<double> ahead(x.size()), behind(x.size());
  ASSERT_TRUE(assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = values.data()}));
  for (std::int32_t column = 0; column < pattern.size; ++column) {
    constexpr double h = 1e-5;
    for (const double side : {h, -h}) {
      u[static_cast<std::size_t>(column)] = side;
      assembler.place(u, x);
      ASSERT_TRUE(assembler.evaluate(x, {.residual = side > 0 ? ahead.data() : behind.data()}));
    }
    u[static_cast<std::size_t>(column)] = 0;
    const auto begin = static_cast<std::size_t>(pattern.column_start[static_cast<std::size_t>(column)]);
    const auto end = static_cast<std::size_t>(pattern.column_start[static_cast<std::size_t>(column) + 1]);
    for (std::size_t entry = begin; entry < end; ++entry) {
      const auto row = static_cast<std::size_t>(pattern.row[entry]);
      EXPECT_NEAR(values[pattern.slot_of(entry)], (ahead[row] - behind[row]) / (2 * h), 1e-4)
          << row << " " << column;
    }
  }
}

/// The left half of the hanging panel. Its middle column can move in the plane x = 0 only.
Scene left_half(int n) {
  Scene whole = sample::hanging_panel(n, 36.5), half = whole;
  std::vector<std::uint32_t> number(whole.node_count(), ~0u);
  half.positions.clear(), half.held.clear(), half.labels.clear();
  for (std::uint32_t node = 0; node < whole.node_count(); ++node) {
    const int column = static_cast<int>(node) % (n + 1);
    if (column > n / 2) continue;
    number[node] = static_cast<std::uint32_t>(half.held.size());
    half.positions.insert(half.positions.end(), &whole.positions[3 * node], &whole.positions[3 * node] + 3);
    half.held.push_back(whole.held[node]  ? std::uint8_t{kAllAxes}
                        : column == n / 2 ? std::uint8_t{kAxisX}
                                          : std::uint8_t{0});
    half.labels.push_back({0, number[node]});
  }
  Part& net = half.parts[0];
  const Part& all = whole.parts[0];
  net.nodes.clear(), net.data.clear();
  for (std::size_t e = 0; 3 * e < all.nodes.size(); ++e) {
    if (number[all.nodes[3 * e]] == ~0u || number[all.nodes[3 * e + 1]] == ~0u ||
        number[all.nodes[3 * e + 2]] == ~0u)
      continue;
    for (std::size_t k = 3 * e; k < 3 * e + 3; ++k) {
      net.nodes.push_back(number[all.nodes[k]]);
      net.data["u"].push_back(all.data.at("u")[k]), net.data["v"].push_back(all.data.at("v")[k]);
    }
    net.data["bar_length"].push_back(0.6);
  }
  return half;
}

TEST(SymmetryPlane, MakesHalfAPanelHangLikeTheWhole) {
  constexpr int n = 8;
  const auto whole = test::solve(sample::hanging_panel(n, 36.5)), half = test::solve(left_half(n));
  ASSERT_EQ(half.solution.status, SolveStatus::converged);
  EXPECT_NEAR(half.solution.energy, whole.solution.energy / 2, 1e-9 * std::abs(whole.solution.energy));
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n / 2; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(half.position(j * (n / 2 + 1) + i)[axis], whole.position(j * (n + 1) + i)[axis], 1e-8);
}

// Positions together with the digits that rounding removes have twice the precision, also at rotated nodes.
TEST(Frames, KeepWhatPositionsRoundOff) {
  const Scene scene = bead_on_a_line();
  Assembler assembler(scene, make_scene_plan(scene, test::shipped_plugins()), 1);
  const std::vector<double> base = assembler.start(), u = {1e-17};
  std::vector<double> x(base.size()), low(base.size());
  assembler.place_from(base, u, x, low);
  EXPECT_EQ(x, base);
  const auto at = [&](int axis) { return assembler.numbering().dof(1, axis).at(); };
  EXPECT_NEAR(low[at(0)], 1e-17 * std::sqrt(0.5), 1e-32);
  EXPECT_NEAR(low[at(2)], -1e-17 * std::sqrt(0.5), 1e-32);
  assembler.place_from(base, std::vector{0.3}, x, low);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double way = i == at(0) ? 0.3 * std::sqrt(0.5) : i == at(2) ? -0.3 * std::sqrt(0.5) : 0;
    EXPECT_NEAR(static_cast<double>((long double){x[i]} + low[i] - base[i] - way), 0, 1e-17);
  }
}

}  // namespace
}  // namespace netloft
