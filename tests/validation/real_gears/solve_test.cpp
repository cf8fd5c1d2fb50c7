// SPDX-License-Identifier: BSD-3-Clause
//
// Solves the gears from FEMNET's answer, slightly perturbed, and from the flat drawing from which FEMNET
// starts.
#include <cmath>
#include <cstdio>

#include "tests/validation/real_gears/gears.hpp"

namespace netloft::real_gears {
namespace {

void print(const NeutralCase& gear, const SolvedGear& s) {
  const Statistics& b = s.solved.solution.cost.statistics;
  std::printf(
      "%s: %zu unknowns, %d iterations, %d factorisations, %.3f s, %.0f times less than FEMNET; furthest "
      "%.1e m; "
      "residual %.1e of the largest tension\n",
      gear.name.c_str(), s.solved.plan.unknowns, b.iterations, b.factorisations, s.cpu_seconds,
      gear.femnet.cpu_seconds / s.cpu_seconds, s.furthest.distance, s.residual_over_tension());
}

test::Solving closely() {
  test::Solving how;
  how.limits.tolerance = 1e-9;
  how.limits.seconds = 60;
  return how;
}

/// Expects that all nodes are within a millimetre of the reference, in balance to a billionth of the largest
/// tension.
void expect_arrival(const NeutralCase& gear, const SolvedGear& s) {
  print(gear, s);
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_LT(s.furthest.distance, 1e-3) << "node " << s.furthest.node;
}

TEST_P(RealGear, ReturnsToFemnetsAnswerWhenPerturbed) {
  for (const std::uint64_t seed : {1, 2, 3})
    expect_arrival(gear_, solve(gear_, {}, {.at_reference = true, .noise = 1e-3, .seed = seed}, closely()));
}

/// Ropes bend by rope/bending, because FEMNET's moments have no potential, whose decrease would lead to
/// equilibrium from a distant start.
Modelling from_afar(const NeutralCase& gear) { return {.shipped_bending = !gear.bends.empty()}; }

/// A full first step from the square in which the ring is drawn would fold the rope into an equilibrium of
/// higher energy.
test::Solving closely_from_afar(const NeutralCase& gear) {
  test::Solving how = closely();
  if (!gear.bends.empty()) how.solver_parameters["damping"] = 1.0;
  return how;
}

/// A gear may have several equilibria: a cod-end that floats in the water may be folded or not. Another
/// answer must be an equilibrium, too: it must return after a perturbation, be held by nearly the same
/// forces, and, if all forces have a potential, have no more energy.
void expect_another_answer(const NeutralCase& gear, const SolvedGear& s) {
  NeutralCase found = gear;
  found.reference.positions = s.positions;
  for (const std::uint64_t seed : {1, 2, 3})
    expect_arrival(
        found, solve(found, from_afar(gear), {.at_reference = true, .noise = 1e-4, .seed = seed}, closely()));
  if (s.solved.plan.conservative) {
    EXPECT_LE(s.energy_above_reference, 0);
  }
  for (const auto& reaction : gear.reference.reactions)
    EXPECT_LT(distance(s.solved.reaction(reaction.node), reaction.force),
              2e-3 * distance(reaction.force, Vector{}));
}

/// A stationary point that was judged unstable: after a perturbation of a tenth of a millimetre, the gear
/// must move away from this point within four times the reported time of tenfold growth, but not from
/// FEMNET's answer, which is stable.
void expect_to_be_left(const NeutralCase& gear, const SolvedGear& s) {
  ASSERT_EQ(s.solved.solution.status, SolveStatus::unstable) << s.solved.solution.reason;
  const double tenfold = std::log(10) / s.solved.solution.growing.rate;
  const auto distance_moved_from = [&](const std::vector<Vector>& positions) {
    NeutralCase there = gear;
    there.reference.positions = positions;
    const Start perturbed{.at_reference = true, .noise = 1e-4};
    return furthest(follow_motion(there, from_afar(gear), perturbed, 4 * tenfold), positions).distance;
  };
  EXPECT_GT(distance_moved_from(s.positions), 1e-3);
  EXPECT_LT(distance_moved_from(gear.reference.positions), 1e-3);
}

/// `newton` alone may end at an unstable point, and then reports it.
TEST_P(RealGear, IsInEquilibriumByNewtonFromTheFlatDrawingOrCalledUnstable) {
  const SolvedGear s = solve(gear_, from_afar(gear_), {}, closely_from_afar(gear_));
  print(gear_, s);
  if (!gear_.triangles.empty()) {  // nothing pulls in the ring
    EXPECT_LT(s.residual_over_tension(), 1e-9);
  }
  if (s.solved.solution.status != SolveStatus::converged) return expect_to_be_left(gear_, s);
  if (s.furthest.distance > 1e-3) expect_another_answer(gear_, s);
}

/// The default strategy from the flat drawing.
TEST_P(RealGear, IsInEquilibriumByTheDefaultStrategy) {
  test::Solving how = closely();
  how.strategy = "auto";
  const SolvedGear s = solve(gear_, from_afar(gear_), {}, how);
  print(gear_, s);
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  if (s.furthest.distance > 1e-3) expect_another_answer(gear_, s);
}

// The closed cod-end of b1 needs more factorisations, because most attempts end with an unstable arrangement
// of knots.
int most_factorisations(const std::string& gear) { return gear == "07_bottom_b1" ? 80 : 50; }

/// Solves the gears with few factorisations. The ring is left out because it is only bent, without tension.
TEST_P(RealGear, IsInEquilibriumFromSoftToStiffWithFewFactorisations) {
  if (gear_.triangles.empty()) GTEST_SKIP() << "no netting";
  test::Solving how = closely();
  how.strategy = "tension/stages";
  const SolvedGear s = solve(gear_, {}, {}, how);
  print(gear_, s);
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_LE(s.solved.solution.cost.statistics.factorisations, most_factorisations(GetParam()));
  EXPECT_LT(s.residual_over_tension(), 1e-9);
  if (s.furthest.distance > 1e-3) expect_another_answer(gear_, s);
}

INSTANTIATE_TEST_SUITE_P(Each, RealGear,
                         testing::Values("01_ring_flexion", "02_netting_panel", "05_pelagic_t1",
                                         "07_bottom_b1", "09_pelagic_s3"),
                         gear_name);

}  // namespace
}  // namespace netloft::real_gears
