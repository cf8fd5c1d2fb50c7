// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/bodies.hpp"

#include "framework/motion/node_masses.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <netloft/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::test {
namespace {

enum Node : std::uint32_t { kAnchor, kUpper, kLower, kTail, kOrigin };
constexpr std::array<double, 3> kToUpper{0.3, 0, 0.4}, kToLower{-0.2, 0, -0.6};

/// A rigid link at the end of a rope of one bar. A heavy rope of one bar hangs from the other end of the
/// link. Ropes and link are tilted at the start.
Scene link_on_a_rope() {
  Scene scene = sample::hanging_rope(1);
  scene.positions = {0, 0, 0, 0.3, 0, -1, -0.2, 0, -2, 0.5, 0, -2.7, 0, 0, -1.4};
  scene.held = {kAllAxes, 0, 0, 0, 0};
  scene.labels.clear();
  for (std::uint32_t n = 0; n < 5; ++n) scene.labels.push_back({0, n});
  Part& rope = scene.parts[0];
  rope.parameters = {{"rope.EA", 1e4}, {"rope.diameter", 0.05}, {"rope.density", 7850.0}};
  rope.nodes = {kAnchor, kUpper, kLower, kTail};
  rope.data["rest_length"] = {1.0, 1.0};
  scene.add_body({.name = "link", .origin = kOrigin, .points = {{kUpper, kToUpper}, {kLower, kToLower}}});
  return scene;
}

/// The scene of link_on_a_rope() with a vane on the link. The link is rotated at the start, in a current that
/// changes with depth.
Scene vane_on_a_rope() {
  Scene scene = link_on_a_rope();
  scene.bodies[0].rotation = {0.4, -0.2, 0.3};
  scene.parts.push_back(
      {"vane", "test/vane", {{"mass", 30.0}, {"inertia", 4.0}, {"drag", 200.0}}, {kOrigin}, {}});
  scene.current = {.samples = {{-10, {0.5, 0.3, 0}}, {0, {1.5, 0.2, 0.1}}}};
  return scene;
}

TEST(Bodies, HandOnTheGradientOfTheEnergyBesideTheResidual) {
  Assembled a(vane_on_a_rope());
  expect_gradient_beside_residual(a, a.moved(0.2));
}

/// With a third point beside the line of the others, positions of the points determine the rotation.
TEST(Bodies, TurnWithThePositionsOfTheirPoints) {
  Scene scene = link_on_a_rope();
  scene.positions.insert(scene.positions.end(), {0, 0.5, -1.4});
  scene.held.push_back(kAllAxes);
  scene.labels.push_back({0, 5});
  scene.bodies[0].points.push_back({5, {0, 0.5, 0}});
  scene.carried.push_back(true);
  Assembled a(std::move(scene));
  std::vector<double> u(static_cast<std::size_t>(a.assembler.numbering().unknowns())),
      x = a.assembler.start();
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.3 * std::cos(static_cast<double>(i));
  a.assembler.place(u, x);
  const auto found = a.assembler.displacements(a.assembler.node_positions(x));
  ASSERT_EQ(found.size(), u.size());
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(found[i], u[i], 1e-12);
}

TEST(Bodies, HangPlumbBetweenTheirRopes) {
  Scene scene = link_on_a_rope();
  scene.bodies[0].held_rotation = kAxisX | kAxisZ;  // nothing resists a rotation about the vertical
  const auto solved = solve(std::move(scene));
  ASSERT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
  EXPECT_EQ(solved.solution.stability, Stability::stable);
  for (const auto node : {kUpper, kLower, kTail}) EXPECT_NEAR(solved.position(node)[0], 0, 1e-9);
  const double length = std::hypot(kToUpper[0] - kToLower[0], kToUpper[2] - kToLower[2]);
  EXPECT_NEAR(solved.position(kUpper)[2] - solved.position(kLower)[2], length, 1e-9);
}

TEST(Bodies, HandTheWholeWeightOnToWhatHoldsThem) {
  Scene scene = link_on_a_rope();
  scene.bodies[0].held_rotation = kAxisX | kAxisZ;
  const auto solved = solve(std::move(scene));
  const double weight = 2 * M_PI / 4 * 0.05 * 0.05 * (7850 - 1025) * 9.81;  // weight of both ropes
  EXPECT_NEAR(solved.reaction(kAnchor)[2], weight, 1e-6);
}

/// The body may rotate about the line through its two points: only the metric resists this.
TEST(Bodies, AreFoundHangingThoughTheyTurnFreelyAboutTheLineOfTheirPoints) {
  const auto solved = solve(link_on_a_rope());
  ASSERT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
  EXPECT_EQ(solved.solution.stability, Stability::neutral);
  for (const auto node : {kUpper, kLower, kTail}) EXPECT_NEAR(solved.position(node)[0], 0, 1e-6);
}

/// Internal forces have no resultant force and no resultant moment about the origin of the world, whether or
/// not bodies carry their nodes.
TEST(Bodies, TakeTheMomentsOfTheirPoints) {
  Sketch s;
  const auto far = s.node(2, 1, 0.5), eye = s.node(0, 0, 0), other = s.node(0, 0, 0),
             origin = s.node(1, 0, 0);
  s.part("spring", "test/spring", {{"k", 100.0}}, {far, eye, far, other}).data["rest_length"] = {0.7, 0.9};
  s.scene.add_body({.name = "b",
                    .origin = origin,
                    .rotation = {0.3, 2.1, -0.8},
                    .points = {{eye, {0.4, 0.1, 0}}, {other, {-0.3, 0, 0.6}}}});
  Assembled a(s.scene);
  std::vector<double> x(a.assembler.start());
  a.assembler.place(std::vector<double>(9, 0.1), x);
  const auto r = a.residual(x);
  const auto at = [&](std::uint32_t node, const std::vector<double>& v) {
    const auto p = a.assembler.node_position(node, v);
    return Vec3<double>{p[0], p[1], p[2]};
  };
  const double arm = s.scene.bodies[0].arm();
  const Vec3<double> psi = (1 / arm) * at(4, x), generalised = arm * at(4, r);
  // the moment m from the generalised force Tᵀm: T⁻ᵀ(ψ) = T⁻¹(−ψ)
  const Vec3<double> moment = rate_of_spin(-psi, generalised);
  const Vec3<double> force = at(far, r) + at(origin, r);
  const Vec3<double> total = cross(at(far, x), at(far, r)) + cross(at(origin, x), at(origin, r)) + moment;
  EXPECT_LT(norm(force), 1e-10);
  EXPECT_LT(norm(total), 1e-10);
  EXPECT_GT(norm(moment), 1);
}

/// Compares the tangent of a body at any rotation with differences of the residual.
void expect_exact_tangent(Assembled& a, const std::vector<double>& u) {
  std::vector<double> x(a.assembler.start());
  const auto matrix = [&] {
    a.assembler.place(u, x);
    return a.matrix(x, MatrixKind::exact);
  }();
  for (std::size_t column = 0; column < u.size(); ++column) {
    constexpr double h = 1e-6;
    std::vector<double> sides[2];
    for (const int side : {0, 1}) {
      auto moved = u;
      moved[column] += side ? h : -h;
      a.assembler.place(moved, x);
      sides[side] = a.residual(x);
    }
    for (std::size_t row = 0; row < u.size(); ++row)
      EXPECT_NEAR(matrix[row * u.size() + column], (sides[1][row] - sides[0][row]) / (2 * h),
                  2e-8 * largest(matrix))
          << row << " " << column;
  }
}

const std::vector<double> kAnywhere{0.1, 0.2, -0.3, 0.05, -0.1, 0.15, 0.7, -0.4, 0.9};

/// The parameter selects the storage: the lower triangle, or the whole matrix.
class BodyTangent : public testing::TestWithParam<bool> {};

TEST_P(BodyTangent, IsTheDerivativeOfTheResidualAtAnyRotation) {
  Assembled a(link_on_a_rope(), 1, [](ScenePlan& plan) { plan.symmetric = GetParam(); });
  ASSERT_EQ(a.assembler.pattern().size, 9);  // unknowns of the tail, of the body's origin and of its rotation
  expect_exact_tangent(a, kAnywhere);
}

INSTANTIATE_TEST_SUITE_P(Symmetric, BodyTangent, testing::Bool());

TEST(Bodies, KeepTheTangentOfElementsThatStandOnThem) {
  Assembled a(vane_on_a_rope());
  EXPECT_FALSE(a.assembler.pattern().symmetric);
  expect_exact_tangent(a, kAnywhere);
}

/// A body on a hinge rotates about a held point.
TEST(Bodies, KeepTheTangentOnAHinge) {
  Scene scene = link_on_a_rope();
  scene.held[kOrigin] = kAllAxes;
  Assembled a(std::move(scene));
  ASSERT_EQ(a.assembler.pattern().size, 6);  // unknowns of the tail and of the rotation
  expect_exact_tangent(a, {0.1, 0.2, -0.3, 0.7, -0.4, 0.9});
}

TEST(Bodies, GiveAResidualThatIsTheGradientOfTheEnergy) {
  Scene scene = vane_on_a_rope();
  scene.current = {};
  Assembled a(std::move(scene));
  std::vector<double> x(a.assembler.start());
  a.assembler.place(kAnywhere, x);
  const auto r = a.residual(x);
  for (std::size_t i = 0; i < kAnywhere.size(); ++i) {
    double energy[2];
    for (const int side : {0, 1}) {
      auto moved = kAnywhere;
      moved[i] += side ? 1e-6 : -1e-6;
      a.assembler.place(moved, x);
      energy[side] = a.energy(x);
    }
    EXPECT_NEAR(r[i], (energy[1] - energy[0]) / 2e-6, 1e-4) << i;
  }
}

/// A vane in motion: its residual F(u, v, a), its tangent and its masses.
class MovingVane : public testing::Test {
 protected:
  Scene scene = vane_on_a_rope();
  ScenePlan plan = make_scene_plan(scene, plugins(), TangentChoice::exact, AnalysisKind::dynamics);
  Assembler assembler{scene, plan, 1};
  std::size_t n = static_cast<std::size_t>(assembler.pattern().size), dofs = assembler.numbering().dofs();
  std::vector<double> u = kAnywhere, v = random_numbers(n, 3), a = random_numbers(n, 4);
  std::vector<double> x = assembler.start(), all_v = x, all_a = x, r = x;

  Kinematics set(const std::vector<double>& at, const std::vector<double>& rate,
                 const std::vector<double>& second, double cu = 1, double cv = 0, double ca = 0) {
    assembler.place(at, x);
    assembler.move(0, x, rate, second, all_v, all_a);
    return {0, all_v.data(), all_a.data(), cu, cv, ca};
  }
  std::vector<double> residual(const std::vector<double>& at, const std::vector<double>& rate,
                               const std::vector<double>& second) {
    const Kinematics motion = set(at, rate, second);
    EXPECT_TRUE(assembler.evaluate(x, {.residual = r.data(), .motion = motion}));
    return {r.begin(), r.begin() + static_cast<std::ptrdiff_t>(n)};
  }
  std::vector<double> matrix(double cu, double cv, double ca) {
    std::vector<double> values(assembler.value_slots()), full(n * n, 0.0);
    const Kinematics motion = set(u, v, a, cu, cv, ca);
    EXPECT_TRUE(
        assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = values.data(), .motion = motion}));
    const SparsePattern& p = assembler.pattern();
    for (std::size_t c = 0; c < n; ++c)
      for (auto k = static_cast<std::size_t>(p.column_start[c]);
           k < static_cast<std::size_t>(p.column_start[c + 1]); ++k)
        full[static_cast<std::size_t>(p.row[k]) * n + c] = values[p.slot_of(k)];
    return full;
  }
};

/// cv and ca are those of an implicit step of 0.1 s, so that all derivatives count.
TEST_F(MovingVane, HasTheExactTangent) {
  const double cv = 20, ca = 400;
  const auto K = matrix(1, cv, ca);
  for (std::size_t column = 0; column < n; ++column) {
    constexpr double h = 1e-6;
    std::vector<double> sides[2];
    for (const int side : {0, 1}) {
      auto to_u = u, to_v = v, to_a = a;
      const double step = side ? h : -h;
      to_u[column] += step, to_v[column] += cv * step, to_a[column] += ca * step;
      sides[side] = residual(to_u, to_v, to_a);
    }
    for (std::size_t row = 0; row < n; ++row)
      EXPECT_NEAR(K[row * n + column], (sides[1][row] - sides[0][row]) / (2 * h), 1e-8 * largest(K))
          << row << " " << column;
  }
}

TEST_F(MovingVane, HasTheRatesOfItsPath) {
  constexpr double h = 1e-4;
  const auto eye_at = [&](double t) {
    auto there = u;
    for (std::size_t i = 0; i < n; ++i) there[i] += t * v[i] + 0.5 * t * t * a[i];
    assembler.place(there, x);
    return assembler.node_position(kLower, x);
  };
  set(u, v, a);
  const auto rate = assembler.node_position(kLower, all_v), second = assembler.node_position(kLower, all_a);
  const auto ahead = eye_at(h), behind = eye_at(-h), here = eye_at(0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(rate[i], (ahead[i] - behind[i]) / (2 * h), 1e-7);
    EXPECT_NEAR(second[i], (ahead[i] - 2 * here[i] + behind[i]) / (h * h), 1e-6);
  }
}

TEST_F(MovingVane, HasMassesThatAreTheDerivativeByAcceleration) {
  NodeMasses masses(assembler);
  const auto M = matrix(0, 0, 1);
  assembler.place(u, x);
  ASSERT_TRUE(masses.update(x));
  std::vector<double> y(n), back(n), direct(n, 0.0);
  masses.multiply(a, y);
  masses.divide(y, back);
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t c = 0; c < n; ++c) direct[row] += M[row * n + c] * a[c];
  EXPECT_LT(largest_difference(back, a), 1e-12);
  EXPECT_LT(largest_difference(y, direct), 1e-10 * largest(direct));
}

/// Removing two full turns from a rotation vector changes no position, velocity or acceleration of a carried
/// node.
TEST_F(MovingVane, StaysWhereItIsWhenItsRotationIsShortened) {
  const double arm = scene.bodies[0].arm();
  const Vec3<double> bit{0.3, -0.5, 0.2}, turns = (1 + 4 * M_PI / norm(bit)) * bit;
  for (int k = 0; k < 3; ++k)
    u[static_cast<std::size_t>(6 + k)] =
        arm * (turns[k] - scene.bodies[0].rotation[static_cast<std::size_t>(k)]);
  set(u, v, a);
  const auto places = x, rates = all_v, seconds = all_a;
  ASSERT_TRUE(assembler.shorten_rotations(u, v, a));
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(
        u[static_cast<std::size_t>(6 + k)] / arm + scene.bodies[0].rotation[static_cast<std::size_t>(k)],
        bit[k], 1e-12);
  set(u, v, a);
  for (const auto node : {kUpper, kLower})
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(assembler.node_position(node, x)[i], assembler.node_position(node, places)[i], 1e-12);
      EXPECT_NEAR(assembler.node_position(node, all_v)[i], assembler.node_position(node, rates)[i], 1e-12);
      EXPECT_NEAR(assembler.node_position(node, all_a)[i], assembler.node_position(node, seconds)[i], 1e-11);
    }
  EXPECT_FALSE(assembler.shorten_rotations(u, v, a));
}

}  // namespace
}  // namespace netloft::test
