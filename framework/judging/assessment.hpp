// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/balance/static_problem.hpp"
#include "framework/judging/linear_motion.hpp"

namespace netloft {

enum class SolveStatus { converged, unstable, not_converged, interrupted };

/// Whether a small disturbance of an equilibrium decays. Where forces have an energy, its tangent tells;
/// where they have none, growth.hpp, and then `stable` means that nothing was found that grows. `swinging`:
/// what grows most goes round, as an empty cod-end flaps (Growth::swings); the gear comes to rest nowhere
/// near, but its motion may stay small.
enum class Stability { stable, neutral, marginal, swinging, unstable, unknown };

/// What a small disturbance of u turns into that grows, where forces have no energy.
struct GrowingMotion {
  std::vector<double> mode;        // over the unknowns, of length 1; empty: nothing is known to grow
  std::vector<double> mode_later;  // where it swings, a quarter of a period later; else empty
  double rate = 0;                 // [1/s]; zero where nothing flows
  double frequency = 0;            // with which it swings [rad/s]
};

/// The Newton step that is left at a point: an estimate of how far it is from the equilibrium.
struct StepLeft {
  std::vector<double> x;                                     // after it, over all dofs; empty: not known
  std::vector<double> x_low;                                 // what that rounds off
  double length = std::numeric_limits<double>::quiet_NaN();  // its largest nodal move [m]
};

/// What the host makes of a point, whoever found it.
struct Assessment {
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;    // a sentence
  std::string at_fault;  // what is furthest from balance, could not be evaluated, or moves most in what grows
  std::vector<double> x, residual;  // over all dofs [m], [N]
  std::vector<double> x_low;        // what x rounds off [m]; empty: not known
  double energy = 0;                // [J]
  Balance balance;
  GrowingMotion growing;
  StepLeft correction;
  Statistics judging;  // counts of what this took
};

/// The last equilibrium whose stability was decided, where forces have no energy: what ends there again, as
/// far as is known, has it.
struct JudgedPoint {
  Assessment assessment;
  std::vector<double> memory;  // what elements remembered
};

/// Where it rests, for linear_motion.hpp.
RestPlace rest_place(const Assessment& a, double gear_size);

/// Forces balance there, whether or not it is stable.
inline bool is_stationary(const Assessment& a) {
  return a.status == SolveStatus::converged || a.status == SolveStatus::unstable;
}

/// Whether or not the scene accepts that.
inline bool flutters(const Assessment& a) { return a.stability == Stability::swinging; }

/// Judges displacements u of the unknowns, at which a solver ended with `outcome`: recomputes the residual,
/// holds it against convergence.hpp, asks of what is balanced whether it is stable, and estimates how far it
/// is from the equilibrium. NETLOFT_STOPPED for a point that no solver is behind.
Assessment assess(StaticProblem& problem, const AssembledScene& scene, const Judging& how,
                  std::span<const double> u, netloft_outcome outcome);

/// The same of a point of the scene, within limits.tolerance.
Assessment assess_static(const AssembledScene& scene, std::span<const double> u, const Limits& limits);

const char* name_of(SolveStatus status);
const char* name_of(Stability stability);

}  // namespace netloft
