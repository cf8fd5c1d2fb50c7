// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/polish.hpp"

#include "framework/judging/correction.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::studies {

namespace {

constexpr int kMostSteps = 20, kTimings = 5;

void measure(StaticProblem& problem, Polished& p) {
  p.evaluated = problem.recompute(p.u, p.x, p.residuals, p.energy);
  if (!p.evaluated) return;
  const Balance balance = problem.balance(p.x, p.residuals);
  p.residual = balance.residual;
  p.load = balance.scale;
}

/// The rounding unit of the largest coordinate [m], which limits the accuracy of positions.
double last_digit(const std::vector<double>& x) {
  double largest = 0;
  for (const double coordinate : x) largest = std::max(largest, std::abs(coordinate));
  return std::numeric_limits<double>::epsilon() * largest;
}

/// Takes one Newton step; `evaluated` of the result is false if there is no such step.
Polished next(StaticProblem& problem, const Polished& from) {
  Polished to;
  std::vector<double> step(from.u.size());
  if (!find_correction(problem, from.u, from.residuals, step)) return to;
  to.u = from.u;
  for (std::size_t i = 0; i < step.size(); ++i) to.u[i] += step[i];
  measure(problem, to);
  return to;
}

}  // namespace

Polished polish(runs::PreparedScene& fresh, const std::vector<double>& u) {
  StaticProblem problem(fresh.assembler(), make_factorisation, {});
  // Displacements are measured from the rounded positions, because displacements from the initial positions
  // would lose digits. This is impossible if there are bodies, because rotations are not displacements.
  const bool counts_from_there = !fresh.assembler().has_bodies();
  Polished best;
  best.u = u;
  if (counts_from_there) {
    problem.count_from(problem.positions(u));
    best.u.assign(u.size(), 0.0);
  }
  measure(problem, best);
  for (int step = 0; step < kMostSteps && best.evaluated; ++step) {
    Polished to = next(problem, best);
    if (!to.evaluated) break;
    const double way =
        std::max(largest_node_distance(fresh.loaded().scene, fresh.assembler().numbering(), best.x, to.x),
                 last_digit(best.x));
    if (!(to.residual < best.residual)) {
      best.uncertainty = way;
      break;
    }
    best = std::move(to);
    best.uncertainty = way;
  }
  if (counts_from_there)
    for (std::size_t i = 0; i < u.size(); ++i) best.u[i] += u[i];
  return best;
}

double factorisation_seconds(runs::PreparedScene& fresh, const std::vector<double>& u) {
  StaticProblem problem(fresh.assembler(), make_factorisation, {});
  netloft_problem& p = problem.interface();
  if (p.evaluate(p.host, NETLOFT_WANT_TANGENT, u.data(), nullptr, nullptr) != NETLOFT_OK) return 0;
  const int how = p.factorise(p.host, NETLOFT_EXACT, 0) == NETLOFT_FACTOR_OK
                      ? NETLOFT_EXACT
                      : NETLOFT_EXACT | NETLOFT_INDEFINITE;
  p.factorise(p.host, how, 0);  // this call is not timed: it may do work that later calls reuse
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTimings; ++i) {
    const double begun = cpu_seconds();
    p.factorise(p.host, how, 0);
    least = std::min(least, cpu_seconds() - begun);
  }
  return least;
}

}  // namespace netloft::studies
