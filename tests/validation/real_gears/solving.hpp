// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/validation/real_gears/case_scene.hpp"
#include "tests/validation/real_gears/comparison.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::real_gears {

/// The shipped plugins and the plugin femnet of these tests.
Registry& plugins();

/// A solved gear and its comparison with the reference.
struct SolvedGear {
  test::Solved solved;
  std::vector<Vector> positions;
  OutOfBalance out_of_balance;
  Furthest furthest;
  Branches branches;
  double largest_tension = 0;  // [N]
  double cpu_seconds = 0;      // plan, assembler and solve
  double energy_above_reference =
      0;  // energy of all forces that have one: not of the water, nor of FEMNET's bending [J]

  double residual_over_tension() const { return solved.solution.balance.residual / largest_tension; }
};

/// The initial guess of the solver.
struct Start {
  bool at_reference = false;  // else from the flat drawing
  double noise = 0;           // standard deviation of each free coordinate [m]
  std::uint64_t seed = 1;
};

SolvedGear solve(const NeutralCase& gear, const Modelling& modelling, const Start& start,
                 const test::Solving& how);

/// Positions of the nodes after a motion of this duration [s], from rest at the start.
std::vector<Vector> follow_motion(const NeutralCase& gear, const Modelling& modelling, const Start& start,
                                  double duration);

/// Solves by the given strategy, or by the default strategy, from the start of the gear.
SolvedGear solve_by_strategy(const NeutralCase& gear, const Modelling& modelling, const Start& start,
                             const test::Solving& how);

}  // namespace netloft::real_gears
