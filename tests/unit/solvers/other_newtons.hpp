// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the tests of Newton's methods of other libraries (kinsol).
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {

inline Solved solve_by(const char* solver, Scene scene, Values parameters = {}, Limits limits = {}) {
  Solving how;
  how.solver = solver, how.solver_parameters = std::move(parameters), how.limits = limits;
  return solve(std::move(scene), how);
}

/// Parameters for whole steps, with a small fraction of the linear stiffness added to the tangent. Such steps
/// converge from slack netting and slack rope.
inline const Values kWholeSteps = {{"strategy", std::string("none")}, {"damping", 1e-3}};

inline void expect_same_shape(const Solved& a, const Solved& b) {
  ASSERT_EQ(a.solution.status, SolveStatus::converged) << a.solution.reason;
  ASSERT_EQ(b.solution.status, SolveStatus::converged) << b.solution.reason;
  for (std::size_t i = 0; i < a.solution.x.size(); ++i)
    EXPECT_NEAR(a.solution.x[i], b.solution.x[i], 1e-5) << i;  // [m], of a rope of 100 m
}

/// The hanging rope, taut, some centimetres from its equilibrium.
inline Scene rope_near_its_shape() {
  const Solved there = solve(sample::hanging_rope(40));
  Scene scene = sample::hanging_rope(40);
  for (std::uint32_t n = 0; n < scene.node_count(); ++n)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(scene.held[n] & (1 << axis)))
        scene.positions[3 * n + axis] =
            there.position(n)[axis] + 0.05 * std::sin(3.0 * n + static_cast<double>(axis));
  return scene;
}

/// A test of Newton's method of another library, given by the name of the solver.
class OtherNewton : public testing::TestWithParam<const char*> {
 protected:
  static Solved solve_by_it(Scene scene, Values parameters = {}, Limits limits = {}) {
    return solve_by(GetParam(), std::move(scene), std::move(parameters), limits);
  }
};

}  // namespace netloft::test
