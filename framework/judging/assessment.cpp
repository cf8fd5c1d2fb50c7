// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/assessment.hpp"

#include "framework/judging/correction.hpp"
#include "framework/judging/growth.hpp"
#include "framework/judging/reasons.hpp"

#include <cmath>
#include <numeric>

namespace netloft {

namespace {

/// Determines the stability from the tangent at u. A point is neutral if its tangent becomes positive
/// definite when a small multiple of the linear stiffness, no larger than rounding errors, is added.
Stability find_stability(StaticProblem& problem, std::span<const double> u) {
  if (problem.factorise_at(u, 0) == NETLOFT_FACTOR_OK) return Stability::stable;
  const netloft_factor shifted = problem.factorise_at(u, kRoundingOfMatrix);
  if (shifted == NETLOFT_FACTOR_OK) return Stability::neutral;
  return shifted == NETLOFT_NOT_POSITIVE ? Stability::unstable : Stability::unknown;
}

bool is_convex_at(StaticProblem& problem, std::span<const double> u) {
  const Stability stability = find_stability(problem, u);
  return stability == Stability::stable || stability == Stability::neutral;
}

/// Whether to accept a point at which a solver has found no step that reduces the residual. The tangent must
/// be positive definite; the full Newton step must increase the residual, because members change between
/// slack and taut; and the energy (1) that this step would gain must be negligible (convergence.hpp):
///   g = ½ r·K⁻¹ r                                                                         (1)
bool no_step_helps(const Assessment& a, StaticProblem& problem, std::vector<double> u) {
  if (!problem.conservative() || !has_nothing_to_gain(problem.imbalance_of(a.balance), 0, 1) ||
      !is_convex_at(problem, u))
    return false;
  std::vector<double> step(u.size()), x, residual;
  if (!solve_for_correction(problem, a.residual, step)) return false;
  const double gain = -0.5 * std::inner_product(step.begin(), step.end(), a.residual.begin(), 0.0);
  if (!has_nothing_to_gain(problem.imbalance_of(a.balance), gain, problem.scales().gear_size())) return false;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += step[i];
  double energy = 0;
  return !problem.recompute(u, x, residual, energy) ||
         problem.balance(x, residual).residual > a.balance.residual;
}

/// Estimates the distance of u from the equilibrium. Uses the factor of the stability check if that check
/// made one.
void find_correction(Assessment& a, StaticProblem& problem, const AssembledScene& scene,
                     std::vector<double> u) {
  std::vector<double> step(u.size());
  const bool has_factor =
      problem.conservative() && (a.stability == Stability::stable || a.stability == Stability::neutral);
  if (!(has_factor ? solve_for_correction(problem, a.residual, step)
                   : find_correction(problem, u, a.residual, step)))
    return;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += step[i];
  a.correction.x = problem.positions(u);
  a.correction.x_low = problem.x_low();
  std::vector<double> way(a.x.size());
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = a.correction.x[i] - a.x[i];
  if (!a.x_low.empty())
    for (std::size_t i = 0; i < way.size(); ++i) way[i] += a.correction.x_low[i] - a.x_low[i];
  a.correction.length =
      largest_node_distance(scene.scene, scene.assembler.numbering(), std::vector<double>(way.size()), way);
}

Stability stability_of(GrowthVerdict verdict) {
  switch (verdict) {
    case GrowthVerdict::none:
      return Stability::stable;
    case GrowthVerdict::marginal:
      return Stability::marginal;
    case GrowthVerdict::grows:
      return Stability::unstable;
    default:
      return Stability::unknown;
  }
}

/// Finds how fast disturbances grow at a point at which the gear has come to rest. Elements with friction
/// meanwhile remember this point instead of an earlier state.
Growth find_growth_at_rest(const AssembledScene& scene, const Assessment& a, StaticProblem& problem) {
  Assembler& assembler = scene.assembler;
  const std::vector<double> past = assembler.memory();
  if (!assembler.remember(a.x)) return {.verdict = GrowthVerdict::unknown};
  LinearMotion motion{.K = problem.matrices().give_away(MatrixKind::exact),
                      .convex = problem.matrices().give_away(MatrixKind::convex)};
  Growth growth = find_growth(assembler, rest_place(a, problem.scales().gear_size()), problem.factors(),
                              std::move(motion));
  assembler.set_memory(past);
  return growth;
}

/// Determines the stability of a point from the motion of the gear, if forces have no potential (drag,
/// pressure).
void find_growing_motion(Assessment& a, const AssembledScene& scene, StaticProblem& problem) {
  Growth growth = find_growth_at_rest(scene, a, problem);
  a.stability = stability_of(growth.verdict);
  if (!growth.grows()) return;
  if (growth.swings()) a.stability = Stability::swinging;
  if (growth.is_local) a.stability = Stability::local;
  a.growing = {std::move(growth.mode), std::move(growth.mode_later), growth.rate,
               growth.swings() ? growth.frequency : 0, growth.share};
}

/// Whether `a` is the equilibrium that was judged before: the distance between both points is at most
/// kSamePlace times the size of the gear, and at most the sum of their estimated errors.
bool is_same(const JudgedPoint& judged, const Assessment& a, const StaticProblem& problem,
             const AssembledScene& scene) {
  const Assessment& before = judged.assessment;
  if (before.x.size() != a.x.size() || judged.memory != scene.assembler.memory()) return false;
  const double apart = largest_node_distance(scene.scene, scene.assembler.numbering(), before.x, a.x);
  return apart == 0 || (apart <= before.correction.length + a.correction.length &&
                        apart <= kSamePlace * problem.scales().gear_size());
}

/// Whether the stability of a judged point may be reused. Points with a doubtful result are examined again.
bool is_decided(Stability s) {
  return s != Stability::neutral && s != Stability::marginal && s != Stability::unknown;
}

void copy_stability(Assessment& a, const Assessment& of) {
  a.stability = of.stability;
  a.growing = of.growing;
}

/// Completes the assessment of a point at which forces are undefined or not finite.
void judge_without_forces(Assessment& a, const StaticProblem& problem, const AssembledScene& of) {
  const auto& [scene, assembler, make] = of;
  if (!problem.met_bad_numbers()) {
    a.at_fault = assembler.fault_place(scene);
    a.reason = "the solver ended at a state without forces: " + assembler.fault_sentence(scene);
    return;
  }
  std::size_t first = 0;
  while (first + 1 < a.residual.size() && std::isfinite(a.residual[first])) ++first;
  a.at_fault = assembler.node_name(scene, assembler.numbering().node(Dof(first)));
  a.reason = "the solver ended at a state where forces overflowed, such as at " + a.at_fault;
}

SolveStatus status_of(const Assessment& a, const StaticProblem& problem, const Judging& how) {
  const bool is_refused =
      a.stability == Stability::unstable || (a.stability == Stability::swinging && !how.accept_oscillation);
  if (a.balance.balanced) return is_refused ? SolveStatus::unstable : SolveStatus::converged;
  return problem.stop() == Stop::interrupted ? SolveStatus::interrupted : SolveStatus::not_converged;
}

/// Sentence about a tangent that is not positive definite, with the node where this was found.
std::string first_not_convex(const StaticProblem& problem, const Assembler& assembler, const Scene& scene) {
  return "its tangent is not positive definite, as was first found at " +
         assembler.node_name(scene,
                             assembler.numbering().node(Dof(std::max(0, problem.last_factor().column))));
}

/// The operations counted in `now` since `before` was counted.
Statistics since(const Statistics& before, const Statistics& now) {
  Statistics b;
  b.energies = now.energies - before.energies;
  b.residuals = now.residuals - before.residuals;
  b.matrices = now.matrices - before.matrices;
  b.solves = now.solves - before.solves;
  b.factorisations = now.factorisations - before.factorisations;
  b.refused_factorisations = now.refused_factorisations - before.refused_factorisations;
  return b;
}

}  // namespace

Assessment assess(StaticProblem& problem, const AssembledScene& of, const Judging& how,
                  std::span<const double> u, netloft_outcome outcome) {
  const auto& [scene, assembler, make] = of;
  const Statistics before = problem.statistics();
  const std::string ending = why_it_ended(outcome, problem, assembler, scene);
  Assessment a;
  const bool evaluated = problem.recompute(u, a.x, a.residual, a.energy);
  a.x_low = problem.x_low();
  if (!evaluated) {
    judge_without_forces(a, problem, of);
    a.judging = since(before, problem.statistics());
    return a;
  }
  a.balance = problem.balance(a.x, a.residual);
  if (outcome == NETLOFT_STEP_TOO_SHORT && !a.balance.balanced)
    a.balance.balanced = a.balance.at_round_off = no_step_helps(a, problem, {u.begin(), u.end()});
  std::string why_unstable;
  bool is_known = false;
  if (a.balance.balanced && problem.conservative()) {
    a.stability = find_stability(problem, u);
    why_unstable = first_not_convex(problem, assembler, scene);
  }
  if (a.balance.balanced) find_correction(a, problem, of, {u.begin(), u.end()});
  if (a.balance.balanced && !problem.conservative() && how.examine_growth) {
    is_known = how.known && is_same(*how.known, a, problem, of);
    if (is_known)
      copy_stability(a, how.known->assessment);
    else
      find_growing_motion(a, of, problem);
    why_unstable = growth_sentence(a, assembler, scene);
  }
  a.status = status_of(a, problem, how);
  const std::string worst = assembler.node_name(scene, a.balance.worst);
  a.at_fault = a.growing.mode.empty() ? worst : node_of_growth(a, assembler, scene);
  a.reason = reason_of(a, ending, worst, why_unstable);
  if (how.known && !is_known && is_decided(a.stability)) *how.known = {a, assembler.memory()};
  a.judging = since(before, problem.statistics());
  return a;
}

RestPlace rest_place(const Assessment& a, double gear_size) {
  const double reach = kSamePlace * gear_size;
  return {.x = a.x,
          .x_low = a.x_low,
          .after = a.correction.x,
          .after_low = a.correction.x_low,
          .fraction = a.correction.length > reach ? reach / a.correction.length : 1};
}

Assessment assess_static(const AssembledScene& scene, std::span<const double> u, const Limits& limits) {
  StaticProblem problem(scene.assembler, scene.make, limits);
  return assess(problem, scene, limits.judging, u, NETLOFT_STOPPED);
}

const char* name_of(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::unstable:
      return "unstable";
    case SolveStatus::interrupted:
      return "interrupted";
    default:
      return "not converged";
  }
}

const char* name_of(Stability stability) {
  switch (stability) {
    case Stability::stable:
      return "stable";
    case Stability::neutral:
      return "neutral";
    case Stability::marginal:
      return "marginal";
    case Stability::local:
      return "locally unstable";
    case Stability::swinging:
      return "swinging";
    case Stability::unstable:
      return "unstable";
    default:
      return "unknown";
  }
}

}  // namespace netloft
