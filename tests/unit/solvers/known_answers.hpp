// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <string>

namespace netloft::test {

/// Solves with a solver and its parameters, and defaults for everything else.
inline Solved solve_with(const std::string& solver, const Scene& scene, Values parameters = {},
                         Limits limits = {}) {
  plugins();  // registers elements for tests, such as "test/load"
  Solving how;
  how.solver = solver, how.solver_parameters = std::move(parameters), how.limits = limits;
  return solve(scene, how);
}

/// Two bars of 4 m with EA = 10 kN between supports 6 m apart; their joint, node 2, is pulled down with 4000
/// N. By Pythagoras (3, 4, 5) it hangs at z = −4 m: each bar is 5 m long, has the tension 10 kN x 1/4, and
/// bears 4/5 of this tension as vertical load. The joint starts above the supports and off the middle, with
/// slack bars.
inline Scene two_bar_truss() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto left = s.node(-3, 0, 0, kAllAxes), right = s.node(3, 0, 0, kAllAxes),
             joint = s.node(0.5, 0.3, 1);
  s.rope("left", {left, joint}, 4, 1e4);
  s.rope("right", {right, joint}, 4, 1e4);
  s.part("load", "test/load", {{"z", -4000.0}}, {joint});
  return s.scene;
}
inline constexpr double kJointOfTruss[] = {0, 0, -4};

/// A bar of 1 m with EA = 100 N hangs from the origin; its end is pulled down with 50 N and pushed sideways
/// by a force that turns with the bar. This force has no potential, and its tangent is unsymmetric. Without
/// the push, the bar is 1.5 m long in equilibrium.
inline Scene pushed_bar(double push) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0.2, 0, -1.2);
  s.rope("bar", {top, end}, 1, 100);
  s.part("load", "test/load", {{"z", -50.0}}, {end});
  s.part("push", "test/follower", {{"k", push}}, {top, end}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar of 1 m with EA = 100 N in tension and compression, held at one end; the other end is pushed in a
/// plane, always at right angles to the bar, so that there is no equilibrium.
inline Scene whirling_bar() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto middle = s.node(0, 0, 0, kAllAxes), end = s.node(1.2, 0, 0, kAxisZ);
  s.rope("bar", {middle, end}, 1, 100).parameters["rope.EA_compression"] = 100.0;
  s.part("push", "test/follower", {{"k", 5.0}}, {middle, end}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar of 1 m with EA = 100 N in tension and compression, nearly upright, with a load of 10 N at its top,
/// which is `aside` to the side of its foot. In equilibrium it stands upright, 0.9 m long and unstable, or
/// hangs, 1.1 m long. The tangent is stored as an unsymmetric matrix, as for pushed_bar().
inline Scene toppling_bar(double aside) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto foot = s.node(0, 0, 0, kAllAxes), top = s.node(aside, 0, 0.9);
  s.rope("bar", {foot, top}, 1, 100).parameters["rope.EA_compression"] = 100.0;
  s.part("load", "test/load", {{"z", -10.0}}, {top});
  s.part("push", "test/follower", {{"k", 0.0}}, {foot, top}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar between nodes 2 m apart, whose force is not defined beyond 1 m.
inline Scene bar_without_forces() {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(2, 0, 0);
  s.part("picky", "test/picky", {{"limit", 1.0}}, {a, b}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar of 1 m with EA = 100 N, stretched to 1.1 m between two supports: there are no unknowns, and the bar
/// pulls with 10 N.
inline Scene bar_between_supports() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1.1, 0, 0, kAllAxes);
  s.rope("bar", {a, b}, 1, 100);
  return s.scene;
}

/// A load on a node that no element holds, so that there is no equilibrium.
inline Scene loose_load() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0, 0, -1.5), loose = s.node(1, 0, 0);
  s.rope("bar", {a, b}, 1, 100);
  s.part("load", "test/load", {{"z", -50.0}}, {loose});
  return s.scene;
}

inline bool has_note(const Solved& s, const std::string& note) {
  for (const IterationRecord& record : s.solution.run.history)
    if (record.note == note) return true;
  return false;
}

inline bool says(const Solved& s, const std::string& piece) {
  return s.solution.reason.find(piece) != std::string::npos;
}

inline double distance(const std::array<double, 3>& a, const double (&b)[3]) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace netloft::test
