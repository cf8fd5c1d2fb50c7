// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/member_problem.hpp"

#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::test {
namespace {

/// Netting that is held along its top and drawn longer than its rest length, with two ropes: one of two bars,
/// and one of a winch that holds its tension.
Scene netting_on_ropes() {
  Sketch s;
  s.scene = sample::hanging_panel(3, 45);
  const auto corner = [](std::uint32_t i, std::uint32_t j) { return 4 * j + i; };
  const auto left = s.node(-40, 5, 3, kAllAxes), half = s.node(-28, 2, 1.5),
             right = s.node(40, 5, 3, kAllAxes);
  s.rope("left", {left, half, corner(0, 1)}, 10).parameters["rope.EA_compression"] = 7.0;
  s.rope("right", {corner(3, 0), right}, 20).parameters["rope.constant_tension"] = 300.0;
  return s.scene;
}

/// A scene as a problem of members, at arbitrary displacements, with the tensions that the law of each member
/// gives there.
struct Taken {
  explicit Taken(Scene given)
      : assembled(std::move(given)),
        problem(assembled.assembler, make_factorisation, {}),
        m(problem.interface()),
        u(random_numbers(m.unknowns, 3)),
        w(3 * std::size_t{m.count}) {
    for (double& d : u) d *= 0.3;
    EXPECT_EQ(m.chords(m.host, u.data(), w.data()), NETLOFT_OK);
    for (std::size_t e = 0; e < m.count; ++e) {
      const double* chord = &w[3 * e];
      const netloft_member& member = m.member[e];
      const double l = std::hypot(chord[0], chord[1], chord[2]), strain = l / member.rest_length - 1,
                   k = strain > 0 ? member.EA : member.EA_compression, T = k * strain, inverse = 1 / l;
      lines.insert(lines.end(), {chord[0] * inverse, chord[1] * inverse, chord[2] * inverse, T,
                                 k / member.rest_length - T * inverse, T * inverse});
    }
  }
  std::vector<double> positions() const {
    std::vector<double> x = assembled.assembler.start();
    assembled.assembler.place(u, x);
    return x;
  }
  Assembled assembled;
  MemberProblem problem;
  netloft_members& m;
  std::vector<double> u, w, lines;
};

TEST(MemberProblem, MakesTheForcesOfTheWholeSceneOfItsMembersAndTheRest) {
  Taken taken(netting_on_ropes());
  netloft_members& m = taken.m;
  const auto whole = taken.assembled.residual(taken.positions());
  std::vector<double> residual(m.dofs), along(m.dofs), f;
  ASSERT_EQ(m.evaluate(m.host, taken.u.data(), residual.data()), NETLOFT_OK);
  along = residual;
  for (std::size_t e = 0; e < m.count; ++e)
    for (std::size_t axis = 0; axis < 3; ++axis)
      f.push_back(taken.lines[6 * e + 3] * taken.lines[6 * e + axis]);
  ASSERT_EQ(m.add_forces(m.host, f.data(), residual.data()), NETLOFT_OK);
  EXPECT_LT(largest_difference(residual, whole), 1e-12 * largest(whole));
  ASSERT_EQ(m.set_matrix_along(m.host, taken.lines.data(), along.data()), NETLOFT_OK);
  EXPECT_LT(largest_difference(along, whole), 1e-12 * largest(whole));
}

/// Multiplies the tangent by arbitrary numbers, and expects that solving for the product gives these numbers
/// again.
void expect_inverse_of_tangent(Taken& taken) {
  netloft_members& m = taken.m;
  const auto K = taken.assembled.matrix(taken.positions(), MatrixKind::exact);
  const auto x = random_numbers(m.unknowns, 5);
  std::vector<double> rhs(m.unknowns), found(m.unknowns);
  for (std::size_t r = 0; r < rhs.size(); ++r)
    for (std::size_t c = 0; c < rhs.size(); ++c) rhs[r] += K[r * rhs.size() + c] * x[c];
  ASSERT_EQ(m.factorise(m.host, NETLOFT_INDEFINITE), NETLOFT_FACTOR_OK);
  ASSERT_EQ(m.solve(m.host, rhs.data(), found.data()), NETLOFT_OK);
  EXPECT_LT(largest_difference(found, x), 1e-7);
}

TEST(MemberProblem, MakesTheTangentOfTheWholeSceneInBothWays) {
  for (const bool has_follower : {false, true}) {
    Scene scene = netting_on_ropes();
    if (has_follower) {  // an unsymmetric tangent
      Sketch s;
      s.scene = scene;
      s.part("push", "test/follower", {{"k", 40.0}}, {5, 6, 10, 6, 8, 4}).data["rest_length"] = {1, 1, 1};
      scene = s.scene;
    }
    Taken taken(scene);
    netloft_members& m = taken.m;
    EXPECT_EQ(m.traits, has_follower ? 0u : std::uint32_t{NETLOFT_SYMMETRIC});
    std::vector<double> residual(m.dofs), K;
    ASSERT_EQ(m.evaluate(m.host, taken.u.data(), residual.data()), NETLOFT_OK);
    ASSERT_EQ(m.set_matrix_along(m.host, taken.lines.data(), residual.data()), NETLOFT_OK);
    expect_inverse_of_tangent(taken);
    for (std::size_t e = 0; e < m.count; ++e) {
      const double *t = &taken.lines[6 * e], a = t[4], b = t[5];
      for (std::size_t i = 0; i < 9; ++i) K.push_back(a * t[i / 3] * t[i % 3] + (i % 4 == 0 ? b : 0));
    }
    ASSERT_EQ(m.set_matrix(m.host, K.data()), NETLOFT_OK) << "again, of the same evaluation";
    expect_inverse_of_tangent(taken);
  }
}

TEST(MemberProblem, ListsMembersByPartAndLeavesOutWhatHasNoStiffness) {
  Taken taken(netting_on_ropes());
  const netloft_members& m = taken.m;
  const auto& parts = taken.assembled.scene.parts;
  std::vector<int> count(parts.size());
  for (std::size_t e = 0; e < m.count; ++e) ++count.at(m.part[e]);
  EXPECT_EQ(m.parts, parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
    EXPECT_EQ(count[p], parts[p].name == "left" ? 2 : parts[p].name == "right" ? 0 : 2 * 18) << parts[p].name;
  EXPECT_EQ(m.largest_coordinate, largest(taken.assembled.assembler.start()));
}

TEST(MemberProblem, FindsChangesOfChordsAlongAStep) {
  Taken taken(netting_on_ropes());
  netloft_members& m = taken.m;
  const auto step = random_numbers(m.unknowns, 9);
  std::vector<double> change(taken.w.size()), there = taken.u, w(taken.w.size());
  ASSERT_EQ(m.changes(m.host, step.data(), change.data()), NETLOFT_OK);
  for (std::size_t i = 0; i < there.size(); ++i) there[i] += step[i];
  ASSERT_EQ(m.chords(m.host, there.data(), w.data()), NETLOFT_OK);
  for (std::size_t i = 0; i < w.size(); ++i) EXPECT_NEAR(w[i], taken.w[i] + change[i], 1e-13);
}

/// A rope to a rotated rigid body, and another rope from the body to a fixed node.
Scene ropes_on_a_body() {
  Sketch s;
  const auto anchor = s.node(-3, 0, 1, kAllAxes), eye = s.node(0, 0, 0), tail = s.node(0, 0, 0),
             end = s.node(4, 0.5, -1), origin = s.node(0, 0.3, -0.2);
  s.rope("warp", {anchor, eye}, 2.5), s.rope("leg", {tail, end}, 3.5);
  s.scene.add_body({.name = "board",
                    .origin = origin,
                    .rotation = {0.3, 0.5, -0.8},
                    .points = {{eye, {-0.4, 0.1, 0.2}}, {tail, {0.5, 0, -0.1}}}});
  return s.scene;
}

/// Whether an unknown belongs to the rotation of the only body.
bool turns(const Taken& taken, std::size_t unknown) {
  return taken.assembled.assembler.numbering().node(Dof(unknown)) ==
         taken.assembled.assembler.body_nodes()[0][1];
}

TEST(MemberProblem, KeepsTheAttitudeOfBodiesOnMembers) {
  Taken taken(ropes_on_a_body());
  netloft_members& m = taken.m;
  const auto whole = taken.assembled.residual(taken.positions());
  const auto K = taken.assembled.matrix(taken.positions(), MatrixKind::exact);
  std::vector<double> residual(m.dofs), found(m.unknowns), rhs(m.unknowns);
  ASSERT_EQ(m.evaluate(m.host, taken.u.data(), residual.data()), NETLOFT_OK);
  ASSERT_EQ(m.set_matrix_along(m.host, taken.lines.data(), residual.data()), NETLOFT_OK);
  auto x = random_numbers(m.unknowns, 5);
  for (std::size_t r = 0; r < rhs.size(); ++r)
    if (turns(taken, r)) x[r] = 0;
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    EXPECT_NEAR(residual[r], turns(taken, r) ? 0 : whole[r], 1e-12 * largest(whole)) << r;
    for (std::size_t c = 0; c < rhs.size() && !turns(taken, r); ++c) rhs[r] += K[r * rhs.size() + c] * x[c];
  }
  ASSERT_EQ(m.factorise(m.host, NETLOFT_INDEFINITE), NETLOFT_FACTOR_OK);
  ASSERT_EQ(m.solve(m.host, rhs.data(), found.data()), NETLOFT_OK);
  EXPECT_LT(largest_difference(found, x), 1e-7);
}

TEST(MemberProblem, FindsChordsAndTheirChangesAtPointsOfBodies) {
  Taken taken(ropes_on_a_body());
  netloft_members& m = taken.m;
  const auto& assembler = taken.assembled.assembler;
  const auto x = taken.positions();
  const auto from = assembler.node_position(0, x), to = assembler.node_position(1, x);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(taken.w[axis], to[axis] - from[axis], 1e-13);
  auto step = random_numbers(m.unknowns, 9);
  for (std::size_t i = 0; i < step.size(); ++i)
    if (turns(taken, i)) step[i] = 0;
  std::vector<double> change(taken.w.size()), there = taken.u, w(taken.w.size());
  ASSERT_EQ(m.changes(m.host, step.data(), change.data()), NETLOFT_OK);
  for (std::size_t i = 0; i < there.size(); ++i) there[i] += step[i];
  ASSERT_EQ(m.chords(m.host, there.data(), w.data()), NETLOFT_OK);
  for (std::size_t i = 0; i < w.size(); ++i) EXPECT_NEAR(w[i], taken.w[i] + change[i], 1e-13);
}

TEST(MemberProblem, ServesMembersOnNodesThatMoveAlongTheAxes) {
  const auto serves = [](const Scene& scene) {
    const Assembled a(scene);
    return MemberProblem::serves(a.scene, a.assembler);
  };
  Scene rope = sample::hanging_rope(4), framed = rope, winch = rope;
  framed.frames[0] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (Part& part : winch.parts) part.parameters["rope.constant_tension"] = 10.0;
  EXPECT_TRUE(serves(rope));
  EXPECT_FALSE(serves(framed));
  EXPECT_FALSE(serves(winch)) << "no member has a stiffness";
}

/// The number of iterations after which `progress` stops a method.
int iterations_allowed(const Limits& limits, Stop& stop) {
  Assembled a(sample::hanging_rope(4));
  std::vector<IterationRecord> records;
  MemberProblem problem(a.assembler, make_factorisation, limits,
                        [&](const IterationRecord& r) { records.push_back(r); });
  netloft_members& m = problem.interface();
  std::vector<double> u(m.unknowns), residual(m.dofs);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(m.evaluate(m.host, u.data(), residual.data()), NETLOFT_OK);
    if (m.progress(m.host, 12.5, "tensions") != NETLOFT_GO_ON) break;
    m.factorise(m.host, NETLOFT_INDEFINITE);
  }
  stop = problem.stop();
  EXPECT_EQ(records.back().residual, 12.5);
  EXPECT_STREQ(records.back().note, "tensions");
  EXPECT_GT(records.back().scale, 0) << "the rope's weight";
  return problem.statistics().iterations;
}

TEST(MemberProblem, GivesUpAtEachOfItsLimits) {
  Stop stop;
  EXPECT_EQ(iterations_allowed({.iterations = 4}, stop), 4);
  EXPECT_EQ(stop, Stop::iterations);
  const std::atomic<bool> now = true;
  EXPECT_EQ(iterations_allowed({.interrupt = &now}, stop), 0);
  EXPECT_EQ(stop, Stop::interrupted);
  const WorkModel model;  // a factorisation costs one unit of work
  Limits limits;
  limits.model = &model, limits.work = 3;
  EXPECT_EQ(iterations_allowed(limits, stop), 3);
  EXPECT_EQ(stop, Stop::work);
}

TEST(MemberProblem, SaysWhereThereAreNoForces) {
  Sketch s;
  s.rope("rope", {s.node(0, 0, 0, kAllAxes), s.node(1, 0, 0)}, 1);
  s.part("picky", "test/picky", {{"limit", 2.0}}, {0, 1}).data["rest_length"] = {1};
  Taken taken(s.scene);
  const std::vector<double> far{10, 0, 0};
  std::vector<double> residual(taken.m.dofs), x(3);
  EXPECT_EQ(taken.m.evaluate(taken.m.host, far.data(), residual.data()), NETLOFT_OUTSIDE_DOMAIN);
  EXPECT_EQ(taken.m.solve(taken.m.host, far.data(), x.data()), NETLOFT_ERROR) << "there is no factor";
}

}  // namespace
}  // namespace netloft::test
