// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/bodies.hpp"

#include "tests/support/sample_scenes.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

enum Node : std::uint32_t { kAnchor, kUpper, kLower, kTail, kPosition, kRotation };
constexpr std::array<double, 3> kToUpper{0.3, 0, 0.4}, kToLower{-0.2, 0, -0.6};

/// A rigid link on a rope of one bar, with a heavy rope of one bar hung from its other end; tilted at the
/// start.
Scene link_on_a_rope() {
  Scene scene = sample::hanging_rope(1);
  scene.positions = {0, 0, 0, 0.3, 0, -1, -0.2, 0, -2, 0.5, 0, -2.7, 0, 0, -1.4, 0, 0, 0};
  scene.held = {kAllAxes, 0, 0, 0, 0, 0};
  scene.labels.clear();
  for (std::uint32_t n = 0; n < 6; ++n) scene.labels.push_back({0, n});
  Part& rope = scene.parts[0];
  rope.parameters = {{"rope.EA", 1e4}, {"rope.diameter", 0.05}, {"rope.density", 7850.0}};
  rope.nodes = {kAnchor, kUpper, kLower, kTail};
  rope.data["rest_length"] = {1.0, 1.0};
  scene.add_body({"link", kPosition, kRotation, {{kUpper, kToUpper}, {kLower, kToLower}}});
  return scene;
}

TEST(Bodies, HangPlumbBetweenTheirRopes) {
  Scene scene = link_on_a_rope();
  scene.held[kRotation] = kAxisX | kAxisZ;  // nothing resists a turn about the plumb line
  const auto solved = test::solve(std::move(scene));
  ASSERT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
  EXPECT_EQ(solved.solution.stability, Stability::stable);
  for (const auto node : {kUpper, kLower, kTail}) EXPECT_NEAR(solved.position(node)[0], 0, 1e-9);
  const double length = std::hypot(kToUpper[0] - kToLower[0], kToUpper[2] - kToLower[2]);
  EXPECT_NEAR(solved.position(kUpper)[2] - solved.position(kLower)[2], length, 1e-9);
}

TEST(Bodies, HandTheWholeWeightOnToWhatHoldsThem) {
  Scene scene = link_on_a_rope();
  scene.held[kRotation] = kAxisX | kAxisZ;
  const auto solved = test::solve(std::move(scene));
  const double weight = 2 * M_PI / 4 * 0.05 * 0.05 * (7850 - 1025) * 9.81;  // of both ropes
  EXPECT_NEAR(solved.reaction(kAnchor)[2], weight, 1e-6);
}

/// Both kinds of storage: the lower triangle, and the whole matrix.
class BodyTangent : public testing::TestWithParam<bool> {};

TEST_P(BodyTangent, IsTheDerivativeOfTheResidualAtAnyRotation) {
  Scene scene = link_on_a_rope();
  Plan plan = make_plan(scene, test::shipped_plugins());
  plan.symmetric = GetParam();
  Assembler assembler(scene, plan, 1);
  const SparsePattern& pattern = assembler.pattern();
  const auto n = static_cast<std::size_t>(pattern.size);
  ASSERT_EQ(n, 9u);  // the tail, the body's position, its rotation
  std::vector<double> u{0.1, 0.2, -0.3, 0.05, -0.1, 0.15, 0.7, -0.4, 0.9}, x(assembler.start());
  std::vector<double> values(assembler.value_slots()), ahead(x.size()), behind(x.size());
  assembler.place(u, x);
  ASSERT_TRUE(assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = values.data()}));
  for (std::size_t column = 0; column < n; ++column) {
    constexpr double h = 1e-6;
    for (const double side : {h, -h}) {
      auto moved = u;
      moved[column] += side;
      assembler.place(moved, x);
      ASSERT_TRUE(assembler.evaluate(x, {.residual = side > 0 ? ahead.data() : behind.data()}));
    }
    for (auto entry = static_cast<std::size_t>(pattern.column_start[column]);
         entry < static_cast<std::size_t>(pattern.column_start[column + 1]); ++entry) {
      const auto row = static_cast<std::size_t>(pattern.row[entry]);
      EXPECT_NEAR(values[pattern.slot_of(entry)], (ahead[row] - behind[row]) / (2 * h), 2e-3)
          << row << " " << column;
    }
  }
}

/// The same for a body on a hinge, which turns about a point that is held.
TEST(Bodies, KeepTheTangentOnAHinge) {
  Scene scene = link_on_a_rope();
  scene.held[kPosition] = kAllAxes;
  Assembler assembler(scene, make_plan(scene, test::shipped_plugins()), 1);
  const SparsePattern& pattern = assembler.pattern();
  ASSERT_EQ(pattern.size, 6);  // the tail, the rotation
  std::vector<double> u{0.1, 0.2, -0.3, 0.7, -0.4, 0.9}, x(assembler.start());
  std::vector<double> values(assembler.value_slots()), ahead(x.size()), behind(x.size());
  assembler.place(u, x);
  ASSERT_TRUE(assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = values.data()}));
  for (std::size_t column = 0; column < u.size(); ++column) {
    for (const double side : {1e-6, -1e-6}) {
      auto moved = u;
      moved[column] += side;
      assembler.place(moved, x);
      ASSERT_TRUE(assembler.evaluate(x, {.residual = side > 0 ? ahead.data() : behind.data()}));
    }
    for (auto entry = static_cast<std::size_t>(pattern.column_start[column]);
         entry < static_cast<std::size_t>(pattern.column_start[column + 1]); ++entry) {
      const auto row = static_cast<std::size_t>(pattern.row[entry]);
      EXPECT_NEAR(values[pattern.slot_of(entry)], (ahead[row] - behind[row]) / 2e-6, 2e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Symmetric, BodyTangent, testing::Bool());

TEST(Bodies, GiveAResidualThatIsTheGradientOfTheEnergy) {
  Scene scene = link_on_a_rope();
  Assembler assembler(scene, make_plan(scene, test::shipped_plugins()), 1);
  std::vector<double> u{0.1, 0.2, -0.3, 0.05, -0.1, 0.15, 0.7, -0.4, 0.9}, x(assembler.start()), r(x.size());
  assembler.place(u, x);
  ASSERT_TRUE(assembler.evaluate(x, {.residual = r.data()}));
  for (std::size_t i = 0; i < u.size(); ++i) {
    double energy[2];
    for (const int side : {0, 1}) {
      auto moved = u;
      moved[i] += side ? 1e-6 : -1e-6;
      assembler.place(moved, x);
      ASSERT_TRUE(assembler.evaluate(x, {.energy = &energy[side]}));
    }
    EXPECT_NEAR(r[i], (energy[1] - energy[0]) / 2e-6, 1e-4) << i;
  }
}

}  // namespace
}  // namespace netloft
