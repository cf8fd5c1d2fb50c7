// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/verdict.hpp"

#include "framework/problem/correction.hpp"
#include "framework/problem/growth.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace netloft {

namespace {

// A direction is neutral when the linear stiffness times this much makes it stable.
constexpr double kNeutral = 1e-9;
// What stiff twines that flicker between slack and taut leave: no more of the largest load, and no more
// energy to gain than this much of the work of that load over the size of the gear.
constexpr double kFlicker = 1e-5, kWorthless = 1e-10;

std::string newtons(double force) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g N", force);
  return text;
}

std::string balance_text(const Solution& s, const Assembler& assembler, const Scene& scene) {
  return "largest residual " + newtons(s.balance.residual) + " at " +
         assembler.node_name(scene, s.balance.worst) + ", largest load " + newtons(s.balance.scale);
}

std::string outcome_text(netloft_outcome outcome, const StaticProblem& problem, const Assembler& assembler,
                         const Scene& scene) {
  switch (outcome) {
    case NETLOFT_STOPPED:
      switch (problem.stop()) {
        case StaticProblem::Stop::iterations:
          return "the limit of " + std::to_string(problem.books().iterations) + " iterations was reached";
        case StaticProblem::Stop::time:
          return "the time limit was reached";
        case StaticProblem::Stop::work:
          return "its budget of work was used up";
        case StaticProblem::Stop::interrupted:
          return "interrupted";
        case StaticProblem::Stop::ran_away:
          return "it runs away: nothing holds what drives it";
        case StaticProblem::Stop::restless:
          return "it goes on moving and does not come to rest";
        default:
          return "the solver stopped by itself";
      }
    case NETLOFT_STEP_TOO_SHORT:
      return "no step brings it closer to balance" +
             (assembler.fault().status == NETLOFT_OUTSIDE_DOMAIN
                  ? ", and some led to a state without forces: " + assembler.fault_sentence(scene)
                  : std::string());
    case NETLOFT_LINEAR_SOLVE: {
      const auto column = problem.last_factor().column;
      return "the tangent stiffness is singular" +
             (column >= 0 ? ", first met at " + assembler.node_name(scene, assembler.numbering().node(column))
                          : std::string());
    }
    case NETLOFT_LEFT_DOMAIN:
      return problem.met_bad_numbers() ? "forces overflowed"
                                       : "a state without forces was met: " + assembler.fault_sentence(scene);
    case NETLOFT_NOT_FINITE:
      return "forces overflowed";
    default:
      if (problem.met_error()) return "an element failed: " + assembler.fault_sentence(scene);
      return std::string("the solver failed") +
             (problem.solver_message()[0] ? std::string(": ") + problem.solver_message() : "");
  }
}

Stability find_stability(StaticProblem& problem, std::span<const double> u) {
  if (problem.factorise_at(u, 0) == NETLOFT_FACTOR_OK) return Stability::stable;
  const netloft_factor shifted = problem.factorise_at(u, kNeutral);
  if (shifted == NETLOFT_FACTOR_OK) return Stability::neutral;
  return shifted == NETLOFT_NOT_POSITIVE ? Stability::unstable : Stability::unknown;
}

/// Where the solver finds no way on, at a convex place, and the host none either: its own step of Newton's
/// leads away from balance, for what is slack here is taut there, and what it would gain is too little for
/// energies to tell:
///   ½ r·K⁻¹ r ≤ ε F L                                                                     (1)
bool has_nothing_to_gain(const Solution& s, StaticProblem& problem) {
  if (s.balance.residual > kFlicker * s.balance.scale || !problem.conservative() ||
      (problem.factorise_at(s.u, 0) != NETLOFT_FACTOR_OK &&
       problem.factorise_at(s.u, kNeutral) != NETLOFT_FACTOR_OK))
    return false;
  std::vector<double> step(s.u.size()), u = s.u, x, residual;
  if (!solve_for_correction(problem, s.residual, step)) return false;
  const double gain = -0.5 * std::inner_product(step.begin(), step.end(), s.residual.begin(), 0.0);
  if (gain > kWorthless * s.balance.scale * problem.gear_size()) return false;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += step[i];
  double energy = 0;
  return !problem.recompute(u, x, residual, energy) ||
         problem.balance(x, residual).residual > s.balance.residual;
}

/// Estimates how far s.u is from the equilibrium; the factor that told of its stability is used again.
void find_correction(Solution& s, StaticProblem& problem, const Assembler& assembler, const Scene& scene) {
  std::vector<double> step(s.u.size()), u = s.u;
  const bool has_factor = s.stability == Stability::stable || s.stability == Stability::neutral;
  if (!(has_factor ? solve_for_correction(problem, s.residual, step)
                   : find_correction(problem, s.u, s.residual, step)))
    return;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += step[i];
  s.corrected = problem.positions(u), s.corrected_low = problem.low_digits();
  std::vector<double> way(s.x.size());
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = s.corrected[i] - s.x[i];
  if (!s.x_low.empty())
    for (std::size_t i = 0; i < way.size(); ++i) way[i] += s.corrected_low[i] - s.x_low[i];
  s.correction = largest_node_distance(scene, assembler.numbering(), std::vector<double>(way.size()), way);
}

/// Where forces have no energy.
void find_what_grows(Solution& s, Assembler& assembler, const MakeFactorisation& make) {
  Growth growth = find_growth(assembler, s.x, make, s.x_low);
  if (!growth.grows()) return;
  s.stability = Stability::unstable;
  s.growing = std::move(growth.mode);
  s.growth_rate = growth.rate, s.growth_frequency = growth.frequency;
}

std::string seconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g s", time);
  return text;
}

/// "a small disturbance grows tenfold in 2.3 s, swinging with a period of 5.9 s"
std::string what_grows(const Solution& s) {
  std::string text = "a small disturbance grows";
  if (s.growth_rate > 0) text += " tenfold in " + seconds(std::log(10) / s.growth_rate);
  if (s.growth_frequency > 0)
    text += ", swinging with a period of " + seconds(2 * std::numbers::pi / s.growth_frequency);
  return text;
}

std::string why_unstable(const Solution& s, const StaticProblem& problem, const Assembler& assembler,
                         const Scene& scene) {
  if (!problem.conservative()) return what_grows(s);
  return "its tangent is not positive definite, first met at " +
         assembler.node_name(scene, assembler.numbering().node(std::max(0, problem.last_factor().column)));
}

/// Where the solver ended there are no forces, or none that are numbers.
void judge_without_forces(Solution& s, const StaticProblem& problem, const Assembler& assembler,
                          const Scene& scene) {
  if (!problem.met_bad_numbers()) {
    s.at_fault = assembler.fault_place(scene);
    s.reason = "the solver ended at a state without forces: " + assembler.fault_sentence(scene);
    return;
  }
  std::size_t first = 0;
  while (first + 1 < s.residual.size() && std::isfinite(s.residual[first])) ++first;
  s.at_fault = assembler.node_name(scene, assembler.numbering().node(static_cast<std::int32_t>(first)));
  s.reason = "the solver ended at a state where forces overflowed, such as at " + s.at_fault;
}

std::string what_rounds(const Solution& s) { return s.x_low.empty() ? "positions" : "elements' lengths"; }

/// `ending` is why the solver returned.
void judge(Solution& s, const std::string& ending, StaticProblem& problem, const Assembler& assembler,
           const Scene& scene) {
  s.at_fault = assembler.node_name(scene, s.balance.worst);
  if (!s.balance.balanced) {
    s.status = problem.stop() == StaticProblem::Stop::interrupted ? SolveStatus::interrupted
                                                                  : SolveStatus::not_converged;
    s.reason = ending + "; " + balance_text(s, assembler, scene);
    if (s.balance.residual <= s.balance.floor)
      s.reason += "; rounding of the " + what_rounds(s) + " alone is worth " + newtons(s.balance.floor) +
                  ": its stiffness is too high for what it carries";
    return;
  }
  s.status = SolveStatus::converged;
  s.reason = balance_text(s, assembler, scene);
  if (s.balance.residual <= s.balance.floor && s.balance.at_round_off)
    s.reason += "; at the round-off of the " + what_rounds(s) + ", which the tolerance is below";
  else if (s.balance.at_round_off)
    s.reason += "; no step brings it closer, and what one could gain is below the rounding of the energy";
  if (s.stability == Stability::unstable) {
    s.status = SolveStatus::unstable;
    s.reason = "a stationary point, but not a stable one: " + why_unstable(s, problem, assembler, scene) +
               "; " + s.reason;
  }
  if (s.stability == Stability::neutral)
    s.reason += "; something in it can move without any force (slack netting or rope)";
}

}  // namespace

Solution solve_static(const Scene& scene, Assembler& assembler, const SolverType& solver,
                      const void* parameters, const Limits& limits, const MakeFactorisation& make,
                      std::function<void(const IterationRecord&)> on_iteration, std::span<const double> start,
                      Digits digits) {
  const double wall = wall_seconds(), cpu = cpu_seconds();
  StaticProblem problem(assembler, make, limits, std::move(on_iteration));
  const bool has_all = digits == Digits::all && start.size() == problem.interface().unknowns;
  if (has_all)
    problem.count_from(problem.positions(start));
  else
    std::copy(start.begin(), start.end(), problem.interface().u);
  const std::uint32_t lacking = solver.solver.needs & ~problem.interface().traits;
  Solution s;
  netloft_outcome outcome = NETLOFT_SOLVER_ERROR;
  if (lacking)
    std::snprintf(problem.interface().message, problem.interface().message_size,
                  "%s needs a problem that is %s", solver.type.c_str(), describe_traits(lacking).c_str());
  else
    outcome = static_cast<netloft_outcome>(solver.solver.solve(parameters, &problem.interface()));
  const double solver_cpu = cpu_seconds() - cpu;

  const std::span<const double> u{problem.interface().u, problem.interface().unknowns};
  s.u.assign(u.begin(), u.end());
  const std::string ending = outcome_text(outcome, problem, assembler, scene);
  const bool evaluated = problem.recompute(u, s.x, s.residual, s.energy);
  s.x_low = problem.low_digits();
  if (evaluated) s.balance = problem.balance(s.x, s.residual);
  if (outcome == NETLOFT_STEP_TOO_SHORT && evaluated && !s.balance.balanced)
    s.balance.balanced = s.balance.at_round_off = has_nothing_to_gain(s, problem);
  s.is_restless = problem.stop() == StaticProblem::Stop::restless;
  s.books = problem.books();
  s.factorisation = problem.factorisation_name();
  if (s.balance.balanced && (problem.interface().traits & NETLOFT_CONSERVATIVE))
    s.stability = find_stability(problem, u);
  else if (s.balance.balanced && limits.ask_growth)
    find_what_grows(s, assembler, make);
  if (s.balance.balanced) find_correction(s, problem, assembler, scene);
  if (evaluated)
    judge(s, ending, problem, assembler, scene);
  else
    judge_without_forces(s, problem, assembler, scene);
  if (s.status == SolveStatus::converged) assembler.remember(s.x);
  if (has_all)
    for (std::size_t i = 0; i < start.size(); ++i) s.u[i] += start[i];
  s.history = problem.history();
  s.books.total_seconds = wall_seconds() - wall;
  s.books.total_cpu_seconds = cpu_seconds() - cpu;
  s.books.solver_cpu_seconds = solver_cpu;
  return s;
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
    case Stability::unstable:
      return "unstable";
    default:
      return "unknown";
  }
}

}  // namespace netloft
