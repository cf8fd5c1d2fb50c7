// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/reasons.hpp"

#include "framework/judging/extent.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace netloft {

namespace {

std::string newtons(double force) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g N", force);
  return text;
}

std::string seconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g s", time);
  return text;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

std::string rounded_quantity(const Assessment& a) {
  return a.x_low.empty() ? "positions" : "elements' lengths";
}

std::string note_on_imbalance(const Assessment& a) {
  if (a.balance.residual > a.balance.floor) return "";
  return "; rounding of the " + rounded_quantity(a) + " alone causes forces of " + newtons(a.balance.floor) +
         ": the stiffness of the gear is too high for its load";
}

std::string note_on_round_off(const Assessment& a) {
  if (!a.balance.at_round_off) return "";
  if (a.balance.residual <= a.balance.floor)
    return "; this residual is round-off of the " + rounded_quantity(a) + ", and the tolerance is smaller";
  return "; no step brings the gear closer to balance, and the energy that a step could gain is below "
         "round-off";
}

std::string note_on_stability(const Assessment& a) {
  if (a.stability == Stability::neutral)
    return "; some part can move without any force (slack netting or rope)";
  if (a.stability == Stability::marginal)
    return "; the equilibrium is close to the limit of stability: whether small disturbances grow is not "
           "certain";
  return "";
}

std::string why_it_stopped(const StaticProblem& problem) {
  switch (problem.stop()) {
    case Stop::iterations:
      return "the limit of " + std::to_string(problem.statistics().iterations) + " iterations was reached";
    case Stop::time:
      return kTimeIsOver;
    case Stop::work:
      return "the budget of work was used up";
    case Stop::interrupted:
      return "interrupted";
    case Stop::ran_away:
      return "the gear runs away: nothing resists the forces that drive it";
    case Stop::unsettled:
      return "the gear keeps moving and does not come to rest";
    default:
      return "the solver stopped by itself";
  }
}

std::vector<double> node_moves(const Assessment& a, const Assembler& assembler) {
  return node_amplitudes(assembler.numbering(), a.growing.mode, a.growing.mode_later);
}

std::uint32_t furthest(const std::vector<double>& moves) {
  return static_cast<std::uint32_t>(std::max_element(moves.begin(), moves.end()) - moves.begin());
}

}  // namespace

std::string why_it_ended(netloft_outcome outcome, const StaticProblem& problem, const Assembler& assembler,
                         const Scene& scene) {
  switch (outcome) {
    case NETLOFT_STOPPED:
      return why_it_stopped(problem);
    case NETLOFT_STEP_TOO_SHORT:
      return "no step brings the gear closer to balance" +
             (assembler.fault().status == NETLOFT_OUTSIDE_DOMAIN
                  ? ", and some led to a state without forces: " + assembler.fault_sentence(scene)
                  : std::string());
    case NETLOFT_LINEAR_SOLVE: {
      if (problem.last_factor().status == FactorStatus::out_of_memory)
        return "there is not enough memory, or room in files, to factorise the matrix";
      const auto column = problem.last_factor().column;
      return "nothing resists some motion of the gear: the tangent stiffness is singular" +
             (column >= 0 ? ", as was first found at " +
                                assembler.node_name(scene, assembler.numbering().node(Dof(column)))
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

std::string growth_sentence(const Assessment& a, const Assembler& assembler, const Scene& scene) {
  std::string text = "a small disturbance grows";
  if (a.growing.rate > 0) text += " tenfold in " + seconds(std::log(10) / a.growing.rate);
  if (flutters(a))
    text += ", swinging with a period of " + seconds(2 * std::numbers::pi / a.growing.frequency);
  if (a.growing.mode.empty()) return text;
  const auto moves = node_moves(a, assembler);
  const double most = moves[furthest(moves)];
  const auto many =
      std::count_if(moves.begin(), moves.end(), [&](double move) { return move >= kMoves * most; });
  return text + ", most at " + node_of_growth(a, assembler, scene) + "; " + std::to_string(many) + " of " +
         std::to_string(moves.size()) + " nodes, with " + percent(a.growing.share) +
         " of the mass, move at least a tenth as far";
}

std::string node_of_growth(const Assessment& a, const Assembler& assembler, const Scene& scene) {
  return assembler.node_name(scene, furthest(node_moves(a, assembler)));
}

std::string balance_text(const Balance& balance, const std::string& worst) {
  return "largest residual " + newtons(balance.residual) + " at " + worst + ", largest load " +
         newtons(balance.scale);
}

std::string reason_of(const Assessment& a, const std::string& ending, const std::string& worst,
                      const std::string& why_unstable) {
  const std::string balance = balance_text(a.balance, worst);
  if (!a.balance.balanced) return ending + "; " + balance + note_on_imbalance(a);
  const std::string balanced = balance + note_on_round_off(a) + note_on_stability(a);
  if (a.stability == Stability::swinging && a.status == SolveStatus::converged)
    return balanced + "; the gear does not rest there: " + why_unstable;
  if (a.stability == Stability::local)
    return balanced + "; a small part of the gear does not rest there: " + why_unstable +
           "; with these nodes held, nothing grows";
  if (a.status != SolveStatus::unstable) return balanced;
  return "a stationary point, but not a stable one: " + why_unstable + "; " + balanced;
}

}  // namespace netloft
