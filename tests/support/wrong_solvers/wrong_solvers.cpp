// SPDX-License-Identifier: BSD-3-Clause
//
// Solvers that are wrong in one place each: gradient descent with a flaw. The description of a solver is the
// name of the only check that must fail: tests/unit/framework/conformance/wrong_solvers_test.cpp reads it.
#include <netloft/solver.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

using namespace netloft;

namespace {

enum class Flaw {
  none,
  says_nothing,
  uphill,
  few_iterations,
  stays_outside,
  starts_elsewhere,
  goes_on,
  moves_on,
  reports_nonsense,
  ignores_factor,
  ignores_overflow,
  counts_calls,
  needs_unknowns,
  keeps_threads
};

/// Descends by u ← u − t M⁻¹ r; t is halved until the step is neither uphill nor too long.
template <Flaw F>
struct Descent {
  struct Parameters {
    double overshoot = 0;
  };
  static constexpr bool has(Flaw flaw) { return F == flaw; }

  static Outcome solve(const Parameters& p, Problem& problem) {
    prepare(problem);
    if (problem.factorise(Matrix::none, 1) != Factor::ok)
      return has(Flaw::ignores_factor) ? Outcome::stopped : Outcome::linear_solve;
    std::vector<double> r(problem.size()), s(problem.size());
    double energy = 0;
    for (int iteration = 0;; ++iteration) {
      if (problem.evaluate(problem.u(), energy, r) != Evaluation::ok) return Outcome::left_domain;
      if (!report(problem, energy, r)) return Outcome::stopped;
      if (has(Flaw::few_iterations) && iteration == 50) return Outcome::step_too_short;
      problem.solve(r, s);
      if (!descend(p, problem, energy, r, s))
        return has(Flaw::ignores_overflow) ? Outcome::stopped : Outcome::step_too_short;
    }
  }

  static void prepare(Problem& problem) {
    if (has(Flaw::needs_unknowns) && problem.size() == 0) throw std::invalid_argument("nothing to solve");
    if (has(Flaw::starts_elsewhere)) std::fill(problem.u().begin(), problem.u().end(), 0.0);
    if (has(Flaw::keeps_threads))
      std::thread([] { std::this_thread::sleep_for(std::chrono::minutes(1)); }).detach();
  }

  static bool report(Problem& problem, double energy, std::vector<double>& r) {
    if (has(Flaw::says_nothing))
      return std::any_of(r.begin(), r.end(), [](double v) { return std::abs(v) > 1e-11; });
    std::vector<double> said = r;
    if (has(Flaw::reports_nonsense))
      for (double& v : said) v *= 1 + 1e-9;
    const bool go_on = problem.progress(problem.u(), energy, said);
    if (!go_on && has(Flaw::goes_on)) problem.evaluate(problem.u(), energy, r);
    if (!go_on && has(Flaw::moves_on) && problem.size()) problem.u()[0] += 1e-14;
    return go_on;
  }

  static double first_length() {
    static int calls = 0;
    const double shorter = has(Flaw::counts_calls) ? 1e-4 * (++calls % 101) : 0;
    return (has(Flaw::uphill) ? -1 : 1) * (1 - shorter);
  }
  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }

  static bool descend(const Parameters& p, Problem& problem, double energy, std::vector<double>& r,
                      const std::vector<double>& s) {
    std::vector<double> u(problem.size());
    const double slope = dot(r, s), first = first_length();
    double there = 0;
    for (double t = 1; t > 1e-12; t /= 2) {
      for (std::size_t i = 0; i < u.size(); ++i) u[i] = problem.u()[i] - first * t * s[i];
      const bool inside = problem.evaluate(u, there, r) == Evaluation::ok;
      if (!inside && has(Flaw::stays_outside)) return false;
      if (!inside || there > energy + 1e-14 * std::abs(energy) || dot(r, s) < -p.overshoot * slope) continue;
      std::copy(u.begin(), u.end(), problem.u().begin());
      return true;
    }
    return false;
  }
};

template <Flaw F>
void add(Plugin& plugin, const char* name, const char* found_by, std::uint32_t needs = NETLOFT_CONSERVATIVE,
         double overshoot = 0.5) {
  using Solver = Descent<F>;
  auto& s = plugin.solver<Solver>(name, found_by);
  s.needs(needs);
  s.real("overshoot", &Solver::Parameters::overshoot, "1", "slope uphill after a step",
         {.lo = 0, .hi = 1, .fallback = overshoot});
}

}  // namespace

NETLOFT_PLUGIN("wrong_solvers", "1", "Solvers that are wrong in one place each") {
  add<Flaw::none>(plugin, "right", "nothing");
  add<Flaw::none>(plugin, "bad_default", "defaults-are-allowed", NETLOFT_CONSERVATIVE, 2);
  add<Flaw::none>(plugin, "claims_too_much", "solves-without-an-energy", 0);
  add<Flaw::says_nothing>(plugin, "says_nothing", "says-progress");
  add<Flaw::uphill>(plugin, "uphill", "solves-a-linear-problem");
  add<Flaw::few_iterations>(plugin, "few_iterations", "solves-a-stiffening-problem");
  add<Flaw::stays_outside>(plugin, "stays_outside", "comes-back-from-outside");
  add<Flaw::starts_elsewhere>(plugin, "starts_elsewhere", "starts-at-the-answer");
  add<Flaw::goes_on>(plugin, "goes_on", "stops-when-told");
  add<Flaw::moves_on>(plugin, "moves_on", "ends-where-it-reported");
  add<Flaw::reports_nonsense>(plugin, "reports_nonsense", "reports-what-is-true");
  add<Flaw::ignores_factor>(plugin, "ignores_factor", "gives-up-without-a-factor");
  add<Flaw::ignores_overflow>(plugin, "ignores_overflow", "gives-up-when-numbers-overflow");
  add<Flaw::counts_calls>(plugin, "counts_calls", "no-hidden-state");
  add<Flaw::needs_unknowns>(plugin, "needs_unknowns", "solves-nothing");
  add<Flaw::keeps_threads>(plugin, "keeps_threads", "starts-no-threads");
}
