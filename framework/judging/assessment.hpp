// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/balance/static_problem.hpp"
#include "framework/judging/linear_motion.hpp"

namespace netloft {

enum class SolveStatus { converged, unstable, not_converged, interrupted };

/// Whether a small disturbance of an equilibrium decays. If all forces have a potential, the tangent decides.
/// Otherwise growth.hpp decides, and `stable` means that no growing disturbance was found. `swinging` means
/// that the fastest growing motion oscillates (Growth::swings), like the flapping of an empty cod-end: the
/// gear does not come to rest near the equilibrium, but its motion may remain small. `local` means that only
/// a negligible part of the gear is swinging or unstable (Growth::is_local).
enum class Stability { stable, neutral, marginal, local, swinging, unstable, unknown };

/// The motion into which a small disturbance of u grows, if forces have no potential (drag, pressure).
struct GrowingMotion {
  std::vector<double> mode;        // shape over the unknowns, of length 1; empty: no growing motion is known
  std::vector<double> mode_later;  // the mode a quarter of a period later; empty: no oscillation
  double rate = 0;                 // growth rate [1/s]; zero if no fluid moves
  double frequency = 0;            // angular frequency [rad/s]; zero if the motion does not oscillate
  double share = 1;                // fraction of the gear's mass that the motion moves, (1) of extent.hpp
};

/// One more Newton step from a point. Its length estimates the distance of the point from the equilibrium.
struct StepLeft {
  std::vector<double> x;      // positions after the step, over all dofs; empty: unknown
  std::vector<double> x_low;  // digits that rounding removes from x [m]; empty: unknown
  double length = std::numeric_limits<double>::quiet_NaN();  // largest nodal displacement of the step [m]
};

/// The host's assessment of a point, independent of how the point was found.
struct Assessment {
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;    // the reason, as a sentence
  std::string at_fault;  // node or element at which the residual is largest, forces are undefined, or growth
                         // is largest
  std::vector<double> x, residual;  // positions [m] and forces [N] over all dofs
  std::vector<double> x_low;        // digits that rounding removes from x [m]; empty: unknown
  double energy = 0;                // [J]
  Balance balance;
  GrowingMotion growing;
  StepLeft correction;
  Statistics judging;  // cost of the assessment
};

/// The last equilibrium whose stability was decided, if forces have no potential (drag, pressure). If a
/// solver ends at the same equilibrium again, the verdict is reused.
struct JudgedPoint {
  Assessment assessment;
  std::vector<double> memory;  // memory of the elements
};

/// Converts the assessed point and its remaining Newton step to the input of linear_motion.hpp.
RestPlace rest_place(const Assessment& a, double gear_size);

/// Whether the forces balance, at a stable or unstable point.
inline bool is_stationary(const Assessment& a) {
  return a.status == SolveStatus::converged || a.status == SolveStatus::unstable;
}

/// Whether the growing motion oscillates. The equilibrium may still be accepted.
inline bool flutters(const Assessment& a) { return a.growing.frequency > 0; }

/// Assesses displacements u of the unknowns, at which a solver ended with `outcome`: recomputes the residual,
/// applies convergence.hpp, determines the stability of a balanced point, and estimates its distance from the
/// equilibrium. `outcome` is NETLOFT_STOPPED for a point that no solver has found.
Assessment assess(StaticProblem& problem, const AssembledScene& scene, const Judging& how,
                  std::span<const double> u, netloft_outcome outcome);

/// Assesses a point of the scene to the tolerance limits.tolerance.
Assessment assess_static(const AssembledScene& scene, std::span<const double> u, const Limits& limits);

const char* name_of(SolveStatus status);
const char* name_of(Stability stability);

}  // namespace netloft
