// SPDX-License-Identifier: BSD-3-Clause
//
// Rigid bodies compared with closed forms: at rest on a rope, swinging about a hinge, tumbling freely.
#include "framework/motion/time_march.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <netloft/attitude.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::test {
namespace {

Vec3<double> vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// A body whose mass is at its origin, on a rope that ends at r in the axes of the body. The body is turned
/// at the start. Nodes: top and end of the rope, the origin, another point `below`.
Sketch body_on_a_rope(const std::array<double, 3>& r, const std::array<double, 3>& turned,
                      const std::array<double, 3>& below = {}) {
  Sketch s;
  const auto top = s.node(0, 0, 0, kAllAxes), eye = s.node(0, 0, 0), origin = s.node(0.1, 0.2, -6),
             other = s.node(0.1, 0.2, -6);
  s.part("rope", "rope/bar", {{"rope.EA", 1e6}, {"rope.diameter", 0.01}, {"rope.density", 1025.0}},
         {top, eye})
      .data["rest_length"] = {5};
  s.part("body", "body/solid", {{"body.mass", 800.0}, {"body.volume", 0.1}}, {origin}).data["side"] = {1};
  s.scene.add_body(
      {.name = "body", .origin = origin, .rotation = turned, .points = {{eye, r}, {other, below}}});
  return s;
}

/// From any start, the body hangs with its centre of mass below the end of the rope. Its rotation about the
/// vertical is undetermined.
TEST(Body, HangsWithItsMassBelowItsEye) {
  for (const std::array<double, 3> turned :
       {std::array<double, 3>{0.3, -0.2, 0.1}, {0, 2.5, 0.3}, {-1.2, 0.8, 2.9}}) {
    const std::array<double, 3> r{0.3, -0.2, 0.5};
    const auto solved = solve(body_on_a_rope(r, turned).scene, {.strategy = "auto"});
    ASSERT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
    const double arm = std::hypot(r[0], r[1], r[2]), tension = (800 - 0.1 * 1025) * 9.81;
    EXPECT_NEAR(solved.position(1)[2] - solved.position(2)[2], arm, 1e-9);
    EXPECT_NEAR(solved.position(1)[0], solved.position(2)[0], 1e-7);
    EXPECT_NEAR(solved.reaction(0)[2], tension, 1e-6 * tension);
  }
}

/// A body of weight W that hangs from an eye at the distance a above its mass and rotates about y only, with
/// a force F at the distance h below its mass. Returns the lateral distance of the mass from the eye.
double aside_by(double a, double h, double F, bool turns_with_it) {
  Sketch s = body_on_a_rope({0, 0, a}, {0, 0.2, 0}, {0, 0, -h});
  s.scene.bodies[0].held_rotation = kAxisX | kAxisZ;
  if (turns_with_it) {
    Part& push = s.part("push", "force/body", {{"force.x", F}}, {2});
    push.data["side"] = {1}, push.data["arm"] = {0, 0, -h};
  } else {
    s.part("push", "force/constant", {{"force.x", F}}, {3}).data["pieces"] = {1};
  }
  const auto solved = solve(s.scene, {.strategy = "auto"});
  EXPECT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
  return solved.position(2)[0] - solved.position(1)[0];
}

/// Moments about the eye: W a sin θ = F (a + h) if the force rotates with the body and stays perpendicular to
/// its arm; W a tan θ = F (a + h) if the force keeps its direction.
TEST(Body, LeansByAForceInItsOwnAxesOrThoseOfTheWorld) {
  constexpr double a = 0.5, h = 0.3, F = 900, W = (800 - 0.1 * 1025) * 9.81;
  EXPECT_NEAR(aside_by(a, h, F, true), F * (a + h) / W, 1e-9);
  EXPECT_NEAR(aside_by(a, h, F, false), a * std::sin(std::atan(F * (a + h) / (W * a))), 1e-9);
}

struct Marching {
  Scene scene;
  ScenePlan plan = make_scene_plan(scene, plugins(), TangentChoice::exact, AnalysisKind::dynamics);
  Assembler assembler{scene, plan, 1};
  MarchSettings settings;

  explicit Marching(Scene given) : scene(std::move(given)) {}
  MarchResult run(const std::string& integrator, const MarchWatch& watch, const MarchState* from = nullptr) {
    const IntegratorType& type = plugins().integrator(integrator);
    std::vector<std::string> wrong;
    const ParameterBlock own(type.parameters, type.integrator.parameter_bytes, {}, wrong);
    const SolverType& newton = plugins().solver("newton");
    const ParameterBlock of_newton(newton.parameters, newton.solver.parameter_bytes, {}, wrong);
    return march({scene, assembler, make_factorisation}, {{&type, own.data()}, {&newton, of_newton.data()}},
                 {.tolerance = 1e-10, .iterations = 50}, settings, watch, from);
  }
};

/// A rod of length l, hinged at its upper end and released when level, reaches the vertical after t = K(sin
/// 45°) √(2l/3g).
TEST(Body, SwingsAboutAHingeInTheTimeOfAPhysicalPendulum) {
  constexpr double l = 2, g = 9.81, m = 30, K = 1.8540746773013719;
  Sketch s;
  const auto hinge = s.node(0, 0, 0, kAllAxes), tip = s.node(l, 0, 0);
  s.scene.water = {0, g};
  s.part("rod", "body/solid",
         {{"body.mass", m},
          {"body.centre_x", l / 2},
          {"body.inertia_y", m * l * l / 12},
          {"body.inertia_x", 0.1},
          {"body.inertia_z", m * l * l / 12}},
         {hinge})
      .data["side"] = {1};
  s.scene.add_body({.name = "rod", .origin = hinge, .points = {{tip, {l, 0, 0}}}});
  Marching m1(s.scene);
  m1.settings.duration = K * std::sqrt(2 * l / (3 * g));
  m1.settings.adaptive = false, m1.settings.step = m1.settings.duration / 400;
  const auto r = m1.run("generalized-alpha", {});
  ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
  std::vector<double> x(m1.assembler.start());
  m1.assembler.place(r.u, x);
  EXPECT_NEAR(m1.assembler.node_position(tip, x)[0], 0, 2e-4);
  EXPECT_NEAR(m1.assembler.node_position(tip, x)[2], -l, 1e-7);
}

/// A body without forces that tumbles about its middle axis, through several turns: its angular momentum and
/// its energy are constant.
TEST(Body, KeepsItsAngularMomentumAsItTumbles) {
  const Vec3<double> J{2, 3, 5}, spin{0.4, 6, 0.3};
  Sketch s;
  const auto origin = s.node(0, 0, 0);
  s.scene.water = {0, 0};
  s.part("body", "body/solid",
         {{"body.mass", 7.0}, {"body.inertia_x", J.x}, {"body.inertia_y", J.y}, {"body.inertia_z", J.z}},
         {origin})
      .data["side"] = {1};
  s.scene.add_body({.name = "body", .origin = origin, .rotation = {0.2, 0.1, -0.3}, .points = {}});
  Marching m(s.scene);
  m.settings.duration = 4, m.settings.adaptive = false, m.settings.step = 1e-3;
  m.settings.output_interval = 0.5, m.settings.budget = true;
  const auto momentum = [&](std::span<const double> x, std::span<const double> v) {
    const Vec3<double> psi = vector_of(m.assembler.rotation(0, x));
    Vec3<double> rate;
    for (int k = 0; k < 3; ++k) rate[k] = v[m.assembler.numbering().dof(1, k).at()];  // the arm is 1 m
    const auto axes = turned_axes(psi);
    const Vec3<double> w = spin_of(psi, rate);
    Vec3<double> L;
    for (int k = 0; k < 3; ++k)
      L += (J[k] * dot(axes[static_cast<std::size_t>(k)], w)) * axes[static_cast<std::size_t>(k)];
    return L;
  };
  MarchState start = state_at_rest(m.assembler);
  const Vec3<double> psi = vector_of(s.scene.bodies[0].rotation), rate = rate_of_spin(psi, spin);
  for (int k = 0; k < 3; ++k) start.v[static_cast<std::size_t>(3 + k)] = rate[k];
  std::vector<Vec3<double>> seen;
  double numerical = 0, kinetic = 0;
  MarchWatch watch;
  watch.on_output = [&](const Snapshot& at) {
    seen.push_back(momentum(at.x, at.v));
    numerical = at.budget->values().back(), kinetic = at.budget->values().front();
  };
  const auto r = m.run("newmark", watch, &start);
  ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
  ASSERT_EQ(seen.size(), 9u);
  for (const auto& L : seen) EXPECT_LT(norm(L - seen[0]), 2e-4 * norm(seen[0]));
  EXPECT_LT(std::abs(numerical), 1e-4 * kinetic);
  EXPECT_GT(norm(seen[0]), 10);
}

}  // namespace
}  // namespace netloft::test
