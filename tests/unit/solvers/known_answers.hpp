// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <string>

namespace netloft::test {

/// Solves with a solver and its parameters, all else as by default.
inline Solved solve_with(const std::string& solver, const Scene& scene, Values parameters = {},
                         Limits limits = {}) {
  plugins();  // "test/load" and its like are among the shipped elements from here on
  Solving how;
  how.solver = solver, how.solver_parameters = std::move(parameters), how.limits = limits;
  return solve(scene, how);
}

/// Two bars of 4 m and 10 kN between supports 6 m apart, their joint pulled down with 4000 N: by Pythagoras
/// (3, 4, 5) both are 5 m long, pull with 10 kN x 1/4, and carry 4/5 of it each. Node 2 hangs at z = −4 m.
/// It starts slack, away from the middle and above.
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

/// A bar of 1 m and 100 N from its top at the origin, pulled down at its end with 50 N and pushed sideways by
/// a force that turns with the bar: no energy, unsymmetric tangent. Without the push, 1.5 m long in balance.
inline Scene pushed_bar(double push) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0.2, 0, -1.2);
  s.rope("bar", {top, end}, 1, 100);
  s.part("load", "test/load", {{"z", -50.0}}, {end});
  s.part("push", "test/follower", {{"k", push}}, {top, end}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar of 1 m and 100 N that bears pressure as well as tension, held at one end; the other is pushed round
/// it in a plane, always at right angles to the bar: there is no balance.
inline Scene whirling_bar() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto middle = s.node(0, 0, 0, kAllAxes), end = s.node(1.2, 0, 0, kAxisZ);
  s.rope("bar", {middle, end}, 1, 100).parameters["rope.EA_compression"] = 100.0;
  s.part("push", "test/follower", {{"k", 5.0}}, {middle, end}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar of 1 m and 100 N that bears pressure as well as tension, nearly upright, loaded with 10 N at its
/// top, `aside` of its foot. In balance it is 0.9 m long upright, which is not stable, or hangs 1.1 m long.
/// Its tangent is as unsymmetric as that of a pushed bar.
inline Scene toppling_bar(double aside) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto foot = s.node(0, 0, 0, kAllAxes), top = s.node(aside, 0, 0.9);
  s.rope("bar", {foot, top}, 1, 100).parameters["rope.EA_compression"] = 100.0;
  s.part("load", "test/load", {{"z", -10.0}}, {top});
  s.part("push", "test/follower", {{"k", 0.0}}, {foot, top}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar that has no force beyond 1 m, between nodes 2 m apart.
inline Scene bar_without_forces() {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(2, 0, 0);
  s.part("picky", "test/picky", {{"limit", 1.0}}, {a, b}).data["rest_length"] = {1};
  return s.scene;
}

/// A bar of 1 m and 100 N, 1.1 m long between two supports: nothing is unknown, its ends are pulled with 10
/// N.
inline Scene bar_between_supports() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1.1, 0, 0, kAllAxes);
  s.rope("bar", {a, b}, 1, 100);
  return s.scene;
}

/// A load on a node that nothing holds: there is no balance.
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
