// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/race.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace netloft::automatic {

namespace {

/// g of (1): the growth of slices that minimises the bound on the cost in race.hpp.
constexpr double kGrowth = 2;

/// Limit of iterations with compensated positions. Of 144 gears in round_off_test.cpp, 140 converge without a
/// limit, 140 with 8 and 143 with 20, because work is left for other attempts.
constexpr unsigned kStepsAtRoundOff = 20;

/// Perturbation used to leave a stationary point, as a fraction of the element size; equilibria closer
/// together than this count as one. It is small because an element can be as long as a whole warp.
constexpr double kBeside = 1e-3;

double little(const Search& search) { return kBeside * search.element_size(); }

bool is_one_place(const Search& search, const Displacements& a, const Displacements& b) {
  double apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i) apart = std::max(apart, std::abs(a[i] - b[i]));
  return apart <= little(search);
}

/// Returns the start of the search. If forces are undefined at the start, no solver can leave this point, and
/// the start is perturbed.
Displacements start_with_forces(Search& search) {
  const Stage start = search.assess({.name = "the start"}, search.start());
  if (start.has_forces() || start.is_stationary()) return search.start();
  return perturbed(search.start(), little(search));
}

/// Returns the saddle displaced by t y to side 0 or side 1, where y is the growing motion, scaled so that no
/// coordinate changes by more than the size of an element. t is the largest of 1, ½, ¼, … for which the force
/// still points away from the saddle:
///   t y·r(u + t y) < 0                                                                    (2)
/// because the gear comes to rest near the greatest such t. If y is not known, the sides are two different
/// perturbations.
Displacements beside(Search& search, const Stage& saddle, const Ask& ask, int side) {
  const double largest = largest_of(saddle.growing);
  if (!(largest > 0) || !std::isfinite(largest)) return perturbed(saddle.u, little(search), side);
  const double element = (side == 0 ? 1 : -1) * search.element_size() / largest;
  return search.with_problem(ask, saddle.u, [&](Problem& problem) {
    std::vector<double> r(problem.size());
    double energy = 0;
    const auto is_driven_on = [&](double t) {
      add_scaled(saddle.u, t * element, saddle.growing, problem.u());
      return problem.evaluate(problem.u(), energy, r) == Evaluation::ok &&
             element * dot(saddle.growing, r) < 0;
    };
    for (double t = 1; t > std::numeric_limits<double>::epsilon() && !is_driven_on(t);) t /= 2;
  });
}

}  // namespace

Race::Race(Search& search, const Options& options)
    : search_(search), options_(options), budget_(search), start_(start_with_forces(search)) {}

Stage Race::run() {
  for (const Attempt& attempt : attempts_for(search_, options_)) runners_.push_back({attempt});
  const auto is_out = [](const Runner& r) { return r.fate == Fate::out; };
  for (double slice = options_.slice; !is_decided() && !std::all_of(runners_.begin(), runners_.end(), is_out);
       slice *= kGrowth)
    run_round(slice);
  return best_;
}

void Race::run_round(double slice) {
  for (Runner& runner : runners_) {
    if (is_decided()) return;
    if (runner.fate == Fate::out) continue;
    run_slice(runner, slice);
    if (runner.fate == Fate::again_at_once && !is_decided()) run_slice(runner, kGrowth * slice);
  }
}

bool Race::is_decided() const { return best_.has_converged() || budget_.is_used_up(); }

void Race::run_slice(Runner& runner, double slice) {
  const double work = std::min(slice, budget_.left());
  const Attempt& attempt = runner.attempt;
  Stage stage =
      search_.call(attempt.strategy, attempt.parameters, {.name = attempt.name, .work = work}, start_);
  const bool is_near = stage.was_cut_off() && stage.has_forces() && stage.imbalance() <= kOnlyAStart;
  const Budget beyond = budget_.split(work);
  stage = off_saddle(std::move(stage), beyond);
  const bool is_out = !stage.was_cut_off() && beyond.spent() < work;
  runner.fate = is_out ? Fate::out : is_near ? Fate::again_at_once : Fate::again;
  // After the first equilibrium with flutter, the race continues for as much work as it has used so far.
  if (stage.flutters()) budget_.end_after(budget_.spent());
  keep_better(with_compensated_positions(std::move(stage)));
}

/// Moves off an unstable equilibrium to one side and, if that does not converge, to the other side. If this
/// leads to a new unstable equilibrium, both sides of the new one are tried instead. An equilibrium with
/// flutter is not left, because the motion comes back to it from either side.
Stage Race::off_saddle(Stage saddle, const Budget& budget) {
  const auto ask = [&] { return Ask{.name = "off an unstable equilibrium", .work = budget.left()}; };
  std::vector<Displacements> met{saddle.u};
  for (int side = 0; side < 2 && saddle.ending == Ending::unstable && !saddle.flutters(); ++side) {
    if (budget.is_used_up()) break;
    const Displacements start = beside(search_, saddle, ask(), side);
    if (budget.is_used_up()) break;
    Stage next = search_.call("direct", "", ask(), start);
    if (next.has_converged()) return next;
    const bool is_another = next.ending == Ending::unstable &&
                            std::none_of(met.begin(), met.end(), [&](const Displacements& one) {
                              return is_one_place(search_, one, next.u);
                            });
    if (is_another) {
      saddle = std::move(next);
      met.push_back(saddle.u);
      side = -1;
    }
  }
  return saddle;
}

/// Solves again with compensated positions if the residual is below the rounding of the positions. The digits
/// that they add are gained in a few steps or not at all, because Newton's method doubles correct digits.
Stage Race::with_compensated_positions(Stage stage) {
  const bool is_rounded =
      stage.has_forces() && stage.residual <= stage.rounding && stage.ending != Ending::unstable;
  if (!is_rounded || search_.remembers() || search_.work_left() == 0 || is_left_out(options_, "compensated"))
    return stage;
  Stage next = search_.solve(
      {.name = "with compensated positions", .iterations = kStepsAtRoundOff, .compensated = true}, stage.u);
  return next.has_converged() && next.residual <= stage.residual ? std::move(next) : std::move(stage);
}

/// Keeps the better of two stages at an equilibrium: a converged one before an unstable one, then the better
/// balanced one.
void Race::keep_better(Stage stage) {
  if (!stage.is_stationary()) return;
  const bool is_better = stage.has_converged() != best_.has_converged()
                             ? stage.has_converged()
                             : !best_.is_stationary() || stage.imbalance() < best_.imbalance();
  if (is_better) best_ = std::move(stage);
}

}  // namespace netloft::automatic
