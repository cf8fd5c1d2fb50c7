// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/verdict.hpp"

namespace netloft {

namespace {

/// The result if no solver was started: the initial positions of the scene, and the reason.
Solution not_started(const Assembler& assembler, std::span<const double> start, std::string why) {
  Solution s;
  s.reason = std::move(why);
  s.u.assign(start.begin(), start.end());
  s.u.resize(static_cast<std::size_t>(assembler.pattern().size), 0.0);
  s.x = assembler.start();
  s.residual.resize(s.x.size(), 0.0);
  assembler.place(s.u, s.x);
  return s;
}

}  // namespace

std::optional<std::string> why_unfit(const SolverType& solver, std::uint32_t problem_traits) {
  const std::uint32_t lacking = solver.solver.needs & ~problem_traits;
  if (!lacking) return {};
  return solver.type + " needs a problem that is " + describe_traits(lacking);
}

Solution solve_static(const AssembledScene& scene, SolverChoice solver, const Limits& limits,
                      StartPoint start, Observer observer) {
  Assembler& assembler = scene.assembler;
  if (auto why = why_unfit(*solver.type, traits_of(assembler)))
    return not_started(assembler, start.u, std::move(*why));
  const double wall = wall_seconds(), cpu = cpu_seconds();
  StaticProblem problem(assembler, scene.make, limits, std::move(observer));
  netloft_problem& p = problem.interface();
  const bool has_all =
      start.positions == Positions::compensated && start.u.size() == p.unknowns && !assembler.has_bodies();
  if (has_all)
    problem.count_from(problem.positions(start.u));
  else
    std::copy(start.u.begin(), start.u.end(), p.u);
  assembler.shorten_rotations({p.u, p.unknowns});
  const auto outcome = call_solver(solver, p);
  assembler.shorten_rotations({p.u, p.unknowns});
  const double solver_cpu = cpu_seconds() - cpu;
  Solution s;
  s.run = {problem.stop(), problem.history(), problem.factorisation_name()};
  s.does_not_settle = problem.stop() == Stop::unsettled;
  s.cost.statistics = problem.statistics();
  const std::span<const double> u{p.u, p.unknowns};
  static_cast<Assessment&>(s) = assess(problem, scene, limits.judging, u, outcome);
  s.u.assign(u.begin(), u.end());
  if (has_all)
    for (std::size_t i = 0; i < start.u.size(); ++i) s.u[i] += start.u[i];
  s.cost.statistics.total_seconds = wall_seconds() - wall;
  s.cost.statistics.total_cpu_seconds = cpu_seconds() - cpu;
  s.cost.statistics.solver_cpu_seconds = solver_cpu;
  return s;
}

}  // namespace netloft
