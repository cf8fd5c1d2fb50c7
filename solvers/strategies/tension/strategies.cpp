// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/strategies.hpp"

#include <algorithm>

namespace netloft::tension {

namespace {

/// Solves the scene itself from u. If this finds an equilibrium, reports it as an answer.
void solve_from(Search& search, Displacements u) {
  const Stage stage = search.solve({.name = "as it is, from there"}, std::move(u));
  if (stage.is_stationary()) search.answer(stage.u);
}

std::string counted(std::size_t members) {
  return std::to_string(members) + (members == 1 ? " member" : " members");
}

/// Whether some member can be slack: a member that resists compression less than tension.
bool some_can_be_slack(const netloft_members& members) {
  return std::any_of(members.member, members.member + members.count,
                     [](const netloft_member& m) { return m.EA_compression < m.EA; });
}

const char* beginning(const Search& search) {
  return search.starts_from_sketch() ? "from the sketch" : "from the given start";
}

}  // namespace

void Only::describe(StrategyTable<Only>& t) {
  t.needs(NETLOFT_SEARCH_MEMBERS);
  t.real("to_boundary", &Parameters::to_boundary, "1",
         "fraction of the distance to the boundary of the cone that a step may cover; members start inside "
         "the cone by a strain of one minus this fraction, and a step towards the centre that is shorter "
         "than that "
         "ends the method",
         {.lo = 0.1, .hi = 0.9999, .fallback = 0.98});
  t.real("least_slack", &Parameters::least_slack, "1",
         "fraction of the members that must be slack at the start; with fewer, the solver finds the slack "
         "ones in less "
         "iterations than this method needs",
         {.lo = 0, .hi = 1, .fallback = 0});
}

void Only::run(const Parameters& parameters, Search& search) {
  if (!(search.load() > 0)) return search.decline("no load acts on the gear");
  bool is_start = false;
  const char* why_not = "the interior-point method did not converge";
  Displacements u = search.with_members(
      {.name = "tension only"}, search.start(), [&](netloft_members& members, std::span<double> there) {
        if (!some_can_be_slack(members)) {
          why_not = "all members resist compression as they do tension";
          return;
        }
        InteriorPoint method(parameters, members);
        if (method.slack_fraction(there) < parameters.least_slack) {
          why_not = "few members are slack at the start";
          return;
        }
        const InteriorPoint::Ending ending = method.solve(there, search.load());
        is_start = ending == InteriorPoint::Ending::converged ||
                   (ending == InteriorPoint::Ending::no_step && method.is_within(kOnlyAStart));
      });
  if (!is_start) return search.decline(why_not);
  solve_from(search, std::move(u));
}

std::string Only::explain(const Parameters&, Search& search) {
  return "interior point, " + counted(search.members()) + " bearing tension only, " + beginning(search) +
         ": no step has to guess which are slack\nthe analysis' solver from there: all forces are unchanged";
}

// Damping is a fraction of the linear stiffness. Values described as fitted were chosen for four real gears,
// from a grid and thousands of random sets of values: tests/validation/README.md, "How sure it is".
void FromSoft::describe(StrategyTable<FromSoft>& t) {
  using P = Parameters;
  t.needs(NETLOFT_SEARCH_MEMBERS);
  t.integer("iterations", &P::iterations,
            "largest number of iterations of a stage: of 150 first stages that converged on a draw of hard "
            "cases, two took more",
            1, 10000, 40);
  const auto add = [&](const char* name, double P::*member, const char* unit, double fallback,
                       const char* doc, double least = 1e-16) {
    t.real(name, member, unit, doc, {.lo = least, .hi = 1e9, .fallback = fallback});
  };
  // Least value of a factor that is applied repeatedly. With 1, the stages would never end; with 1.1, a limit
  // rises from 1 to the default of `last` in 104 stages.
  constexpr double kLeastGrowth = 1.1;
  add("softest", &P::softest, "1", 7e-4, "factor on all stiffness in the first stage; fitted");
  add("ratio", &P::ratio, "1", 5,
      "stiffness of a part over its tension in the second stage, and factor on this ratio from stage to "
      "stage; fitted",
      kLeastGrowth);
  add("last", &P::last, "1", 2e4,
      "largest ratio of stiffness to tension in the stages, before parts have their own stiffness; a part is "
      "taken to bear at least the largest tension of all parts divided by this");
  add("tolerance", &P::tolerance, "1", 0.15,
      "largest residual over the largest reaction that ends the first stage; fitted");
  add("damping", &P::damping, "1", 2e-5, "initial damping of later stages; fitted");
  add("turn", &P::turn, "rad", 0.25, "limit of a member's rotation in one step of a later stage; fitted");
  add("factor", &P::factor, "1", 10,
      "factor by which damping falls after a whole step and rises where a matrix cannot be factorised; in "
      "the first stage damping follows the residual, by no more than this factor",
      kLeastGrowth);
}

void FromSoft::run(const Parameters& parameters, Search& search) {
  Displacements u = search.with_members(
      {.name = "from soft to stiff, tensions as unknowns"}, search.start(),
      [&](netloft_members& members, std::span<double> there) { Stages(parameters, members).solve(there); });
  if (all_finite(u)) solve_from(search, std::move(u));
}

std::string FromSoft::explain(const Parameters&, Search& search) {
  return "stages from soft to stiff, the tensions of " + counted(search.members()) + " as unknowns, " +
         beginning(search) +
         ": stiff ropes turn without being stretched\nthe analysis' solver from there: all forces are "
         "unchanged";
}

}  // namespace netloft::tension
