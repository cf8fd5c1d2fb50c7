// SPDX-License-Identifier: BSD-3-Clause
// Checks of a solver: it finds equilibria that exist, ends when the host stops it, and reports its outcome
// correctly.
#include "framework/conformance/checklist.hpp"
#include "framework/conformance/method_bench.hpp"
#include "framework/conformance/practice.hpp"
#include "framework/conformance/timing.hpp"

#include <algorithm>
#include <cstring>

namespace netloft {

namespace conformance {
namespace {

struct SolverBench : MethodBench {
  SolverBench(const SolverType& t, const ConformanceOptions& o)
      : MethodBench(t.parameters, t.solver.parameter_bytes, o), type(t) {}

  int solve(PracticeProblem& problem) {
    return guarded(type.type, "solve", NETLOFT_SOLVER_ERROR,
                   [&] { return type.solver.solve(parameters.data(), &problem.interface()); });
  }
  bool needs(std::uint32_t traits) const { return type.solver.needs & traits; }

  const SolverType& type;
};

const Practice kLinearProblem{};
const Practice kStiffening{.stiffening = 1e5};
const Practice kWalled{.wall = 0.3};
const Practice kSwirling{.swirl = 5};
const Practice kAll[] = {kLinearProblem, kStiffening, kWalled};

Finding solver_lets_no_exception_escape(SolverBench& b) {
  for (Practice p : kAll)
    for (const bool hostile : {false, true}) {
      p.no_factor = p.no_number = hostile;
      PracticeProblem problem(p);
      b.solve(problem);
    }
  return judged(b.thrown);
}

constexpr double kBalanced = 1e-9;

Finding solves(SolverBench& b, const Practice& like) {
  PracticeProblem problem(like);
  const int outcome = b.solve(problem);
  Finding f;
  f.figure = problem.imbalance(problem.u());
  f.limit = kBalanced;
  f.passed = f.figure <= f.limit;
  f.detail = "outcome " + std::to_string(outcome) + " after " + std::to_string(problem.iterations) +
             " iterations, " + std::to_string(problem.evaluations) + " evaluations";
  return f;
}

Finding solves_a_linear_problem(SolverBench& b) { return solves(b, kLinearProblem); }
Finding solves_a_stiffening_problem(SolverBench& b) { return solves(b, kStiffening); }
Finding comes_back_from_outside(SolverBench& b) { return solves(b, kWalled); }

Finding solves_without_an_energy(SolverBench& b) {
  if (b.needs(NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC))
    return not_applicable("it says that it needs an energy or a symmetric tangent");
  return solves(b, kSwirling);
}

Finding starts_at_the_answer(SolverBench& b) {
  PracticeProblem first(kLinearProblem), again(kLinearProblem);
  b.solve(first);
  std::copy(first.u().begin(), first.u().end(), again.interface().u);
  b.solve(again);
  Finding f;
  f.figure = again.iterations;
  f.limit = 1;
  f.passed = f.figure <= f.limit;
  f.detail = "iterations from a point that is an equilibrium";
  return f;
}

Finding stops_when_told(SolverBench& b) {
  for (const int after : {1, 2}) {
    Practice p = kStiffening;
    p.interrupted_after = after;
    PracticeProblem problem(p);
    const int outcome = b.solve(problem);
    if (problem.iterations < after) continue;  // the solver ended before the interrupt
    if (problem.iterations > after || problem.evaluations_after_stop > 0)
      return failed("went on for " + std::to_string(problem.iterations - after) + " iterations and " +
                    std::to_string(problem.evaluations_after_stop) + " evaluations");
    if (outcome != NETLOFT_STOPPED) return failed("returned outcome " + std::to_string(outcome));
  }
  return {};
}

Finding ends_where_it_reported(SolverBench& b) {
  for (const auto& p : kAll) {
    PracticeProblem problem(p);
    if (b.solve(problem) == NETLOFT_STOPPED && problem.reported != problem.u())
      return failed("`u` is not the last point that was given to `progress`");
  }
  return {};
}

Finding reports_what_is_true(SolverBench& b) {
  Worst worst(1e-12);
  for (const auto& p : kAll) {
    PracticeProblem problem(p);
    b.solve(problem);
    if (problem.iterations > 0)
      worst.note(problem.worst_report, [] { return "a residual given to `progress`"; });
  }
  return judged(worst, "it never calls `progress`");
}

Finding says_progress(SolverBench& b) {
  PracticeProblem problem(kLinearProblem);
  b.solve(problem);
  return problem.iterations > 0 ? Finding{} : failed("ended without a single call of `progress`");
}

/// Checks that the solver returns with a correct outcome from a problem that it cannot solve.
Finding gives_up(SolverBench& b, const Practice& p, const char* where) {
  PracticeProblem problem(p);
  const int outcome = b.solve(problem);
  if (outcome < NETLOFT_STOPPED || outcome > NETLOFT_SOLVER_ERROR)
    return failed(std::string(where) + ": " + std::to_string(outcome) + " is no outcome");
  if (outcome == NETLOFT_STOPPED && !problem.told_to_stop())
    return failed(std::string(where) + ": it reports that the host stopped it, which is not true");
  return {};
}

Finding gives_up_without_a_factor(SolverBench& b) {
  return gives_up(b, {.no_factor = true}, "no matrix could be factorised");
}
Finding gives_up_when_numbers_overflow(SolverBench& b) {
  return gives_up(b, {.no_number = true}, "numbers overflowed");
}

Finding solver_has_no_hidden_state(SolverBench& b) {
  std::vector<double> first;
  for (int round = 0; round < 2; ++round) {
    PracticeProblem problem(kStiffening), other(kWalled);
    b.solve(problem);
    b.solve(other);
    if (round == 0) first = problem.u();
    if (std::memcmp(first.data(), problem.u().data(), first.size() * sizeof(double)) != 0)
      return failed("two solves of the same problem give different answers");
  }
  return {};
}

Finding solves_nothing(SolverBench& b) {
  PracticeProblem problem({.unknowns = 0});
  const int outcome = b.solve(problem);
  return outcome == NETLOFT_STOPPED ? Finding{} : failed("returned outcome " + std::to_string(outcome));
}

// The order matters: a check comes after the checks on which it depends.
const std::vector<Check<SolverBench>>& solver_table() {
  static const std::vector<Check<SolverBench>> checks = {
      {"defaults-are-allowed",
       method_defaults_are_allowed,
       {},
       "a default must lie in the range that its own parameter allows"},
      {"no-exception-escapes",
       solver_lets_no_exception_escape,
       {"defaults-are-allowed"},
       "catch every exception before it leaves the plugin, as the code of solver.hpp does; leave rounding "
       "and "
       "traps as they were"},
      {"says-progress",
       says_progress,
       {"no-exception-escapes"},
       "call `progress` once for every accepted point, including the first"},
      {"solves-a-linear-problem",
       solves_a_linear_problem,
       {"says-progress"},
       "a chain of springs: check the sign of the step. r is the gradient of the energy, and the force is "
       "-r"},
      {"solves-a-stiffening-problem",
       solves_a_stiffening_problem,
       {"solves-a-linear-problem"},
       "the stiffness changes along the path: is a step that raises the energy rejected?"},
      {"comes-back-from-outside",
       comes_back_from_outside,
       {"solves-a-linear-problem"},
       "if `evaluate` returns outside_domain, there are no forces; try a shorter step"},
      {"solves-without-an-energy",
       solves_without_an_energy,
       {"solves-a-linear-problem"},
       "drag has no energy; a method that requires one declares needs(NETLOFT_CONSERVATIVE)"},
      {"starts-at-the-answer",
       starts_at_the_answer,
       {"solves-a-linear-problem"},
       "start at `problem.u()`, and call `progress` before the first step"},
      {"stops-when-told",
       stops_when_told,
       {"says-progress"},
       "when `progress` ends the iteration, return Outcome::stopped and evaluate nothing more"},
      {"ends-where-it-reported",
       ends_where_it_reported,
       {"stops-when-told"},
       "leave in `problem.u()` the last point passed to `progress`"},
      {"reports-what-is-true",
       reports_what_is_true,
       {"says-progress"},
       "pass `progress` the residual of the same point, not of the previous one or of a trial"},
      {"gives-up-without-a-factor",
       gives_up_without_a_factor,
       {"says-progress"},
       "check the result of `factorise`; return Outcome::linear_solve if it failed"},
      {"gives-up-when-numbers-overflow",
       gives_up_when_numbers_overflow,
       {"says-progress"},
       "bound the search for a step; return Outcome::left_domain or step_too_short if it failed"},
      {"no-hidden-state",
       solver_has_no_hidden_state,
       {"says-progress"},
       "no static or mutable variables: the same problem has the same answer, bit for bit"},
      {"solves-nothing", solves_nothing, {"says-progress"}, "a scene may have no unknowns at all"},
      {"starts-no-threads",
       method_starts_no_threads,
       {},
       "the program runs threads of its own; a thread started by a plugin slows them down"},
  };
  return checks;
}

/// Time per unknown and iteration.
TermTiming time_solving(SolverBench& b, const Practice& like, const char* name) {
  int iterations = 1;
  const double spent = least_nanoseconds([&] { return PracticeProblem(like); },
                                         [&](PracticeProblem& problem) {
                                           b.solve(problem);
                                           iterations = std::max(problem.iterations, 1);
                                         });
  return {name, std::to_string(iterations) + " iterations", spent / iterations / like.unknowns,
          "iteration and unknown"};
}

}  // namespace
}  // namespace conformance

ConformanceReport check_solver(const SolverType& type, const ConformanceOptions& options) {
  using namespace conformance;
  ConformanceReport report;
  report.type = type.type;
  SolverBench bench(type, options);
  Doubtful doubtful;
  report.checks = run_all(solver_table(), bench, doubtful);
  if (options.timings && !doubtful.among({"says-progress"}))
    report.timings = {time_solving(bench, kLinearProblem, "linear problem"),
                      time_solving(bench, kStiffening, "stiffening problem")};
  return report;
}

std::vector<std::string> solver_checks() { return conformance::names_of(conformance::solver_table()); }

}  // namespace netloft
