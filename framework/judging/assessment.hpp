// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/balance/static_problem.hpp"
#include "framework/judging/linear_motion.hpp"

namespace netloft {

enum class SolveStatus { converged, unstable, not_converged, interrupted };

/// Whether a small disturbance of an equilibrium decays. The tangent decides if forces have an energy.
/// Otherwise growth.hpp decides, and `stable` means that it found no growing disturbance. `swinging` means
/// that the motion that grows most oscillates, as an empty cod-end flaps (Growth::swings): the gear comes to
/// rest nowhere near, but its motion may remain small.
enum class Stability { stable, neutral, marginal, swinging, unstable, unknown };

/// The motion into which a small disturbance of u grows, if forces have no energy.
struct GrowingMotion {
  std::vector<double> mode;        // over the unknowns, of length 1; empty: no growing motion is known
  std::vector<double> mode_later;  // a quarter of a period later, if it oscillates; else empty
  double rate = 0;                 // [1/s]; zero if no fluid moves
  double frequency = 0;            // of the oscillation [rad/s]
};

/// The remaining Newton step at a point: an estimate of its distance from the equilibrium.
struct StepLeft {
  std::vector<double> x;                                     // after the step, over all dofs; empty: unknown
  std::vector<double> x_low;                                 // low-order part of x
  double length = std::numeric_limits<double>::quiet_NaN();  // its largest nodal move [m]
};

/// The host's assessment of a point, independent of how the point was found.
struct Assessment {
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;  // a sentence
  std::string
      at_fault;  // node or element of the largest residual, of undefined forces, or of the largest growth
  std::vector<double> x, residual;  // over all dofs [m], [N]
  std::vector<double> x_low;        // low-order part of x [m]; empty: unknown
  double energy = 0;                // [J]
  Balance balance;
  GrowingMotion growing;
  StepLeft correction;
  Statistics judging;  // cost of the assessment
};

/// The last equilibrium whose stability was decided, if forces have no energy. A solver that ends there again
/// receives the same verdict.
struct JudgedPoint {
  Assessment assessment;
  std::vector<double> memory;  // of the elements
};

/// The point and its remaining Newton step, as input of linear_motion.hpp.
RestPlace rest_place(const Assessment& a, double gear_size);

/// Whether forces balance, stable or not.
inline bool is_stationary(const Assessment& a) {
  return a.status == SolveStatus::converged || a.status == SolveStatus::unstable;
}

/// Whether an oscillation grows, accepted or not.
inline bool flutters(const Assessment& a) { return a.stability == Stability::swinging; }

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
