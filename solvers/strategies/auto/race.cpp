// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/race.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace netloft::automatic {

namespace {

/// The growth g of slices in (1) of race.hpp. This value minimises the bound on the cost given there.
constexpr double kGrowth = 2;

/// Limit of iterations with compensated positions, which have additional digits. Without a limit, other
/// attempts would get too little work: of 144 gears in round_off_test.cpp, 140 converge without a limit, 140
/// with a limit of 8, and 143 with 20.
constexpr unsigned kStepsAtRoundOff = 20;

/// Perturbation with which a stationary point is left, as a fraction of the element size. Equilibria closer
/// together than this count as one. It is small, because a single element may represent a whole warp.
constexpr double kBeside = 1e-3;

double little(const Search& search) { return kBeside * search.element_size(); }

bool is_one_place(const Search& search, const Displacements& a, const Displacements& b) {
  double apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i) apart = std::max(apart, std::abs(a[i] - b[i]));
  return apart <= little(search);
}

/// Returns the start of the search. It is perturbed if forces are undefined there, because no solver could
/// leave it.
Displacements start_with_forces(Search& search) {
  const Stage start = search.assess({.name = "the start"}, search.start());
  if (start.has_forces() || start.is_stationary()) return search.start();
  return perturbed(search.start(), little(search));
}

/// Returns the saddle displaced by t y to side 0 or side 1. y is the growing motion, scaled so that its
/// largest coordinate is the size of an element. t is the largest of 1, ½, ¼, … for which the force still
/// points away from the saddle:
///   t y·r(u + t y) < 0                                                                    (2)
/// The next equilibrium is expected near the greatest such t. If y is not known, the sides are two different
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
  for (double slice = options_.slice; !is_decided() && !runners_.empty(); slice *= kGrowth) run_round(slice);
  return best_;
}

void Race::run_round(double slice) {
  for (Runner& runner : runners_) {
    if (is_decided()) return;
    run_slice(runner, slice);
    if (runner.fate == Fate::again_at_once && !is_decided()) run_slice(runner, kGrowth * slice);
  }
  std::erase_if(runners_, [](const Runner& runner) { return runner.fate == Fate::out; });
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
  // After the first equilibrium with flutter, the race goes on with as much work as it has used so far.
  if (stage.flutters()) budget_.end_after(budget_.spent());
  keep_better(with_compensated_positions(std::move(stage)));
}

/// Moves off an unstable equilibrium to one side and, if that does not converge, to the other side. If this
/// leads to another unstable equilibrium that this race has not met before, both sides of the new one are
/// tried instead. An equilibrium with flutter is not left, because the gear would swing back to it from
/// either side.
Stage Race::off_saddle(Stage stage, const Budget& budget) {
  while (stage.ending == Ending::unstable && !stage.flutters()) {
    const std::size_t at = find_saddle(std::move(stage));
    std::optional<Stage> next = leave(at, budget);
    if (!next) return saddles_[at].stage;
    stage = std::move(*next);
  }
  return stage;
}

/// Returns the index of an unstable equilibrium among those that this race has met; adds it if it is new.
std::size_t Race::find_saddle(Stage stage) {
  const auto found = std::find_if(saddles_.begin(), saddles_.end(), [&](const Saddle& known) {
    return is_one_place(search_, known.stage.u, stage.u);
  });
  if (found != saddles_.end()) return static_cast<std::size_t>(found - saddles_.begin());
  keep_better(stage);
  saddles_.push_back({std::move(stage)});
  return saddles_.size() - 1;
}

/// Solves from those sides of a saddle at which the search has not ended yet. Returns the first equilibrium
/// that was not met before, or nothing.
std::optional<Stage> Race::leave(std::size_t at, const Budget& budget) {
  const auto ask = [&] {
    return Ask{.name = "moved away from an unstable equilibrium", .work = budget.left()};
  };
  for (int side = 0; side < 2 && !budget.is_used_up(); ++side) {
    if (saddles_[at].is_tried[side]) continue;
    const Displacements start = beside(search_, saddles_[at].stage, ask(), side);
    if (budget.is_used_up()) break;
    Stage next = search_.call("direct", "", ask(), start);
    saddles_[at].is_tried[side] = !next.was_cut_off();
    if (next.has_converged()) return next;
    if (next.ending != Ending::unstable) continue;
    const std::size_t met = saddles_.size();
    if (next.flutters() || find_saddle(next) == met) return next;
  }
  return {};
}

/// Solves again with compensated positions if the residual is below the rounding of the positions. Either a
/// few steps are enough or none help, because Newton's method doubles the number of correct digits in each
/// step.
Stage Race::with_compensated_positions(Stage stage) {
  const bool is_rounded =
      stage.has_forces() && stage.residual <= stage.rounding && stage.ending != Ending::unstable;
  if (!is_rounded || search_.remembers() || search_.work_left() == 0 || is_left_out(options_, "compensated"))
    return stage;
  Stage next = search_.solve(
      {.name = "with compensated positions", .iterations = kStepsAtRoundOff, .compensated = true}, stage.u);
  return next.has_converged() && next.residual <= stage.residual ? std::move(next) : std::move(stage);
}

/// Keeps the better of two equilibria. A converged one is better than an unstable one. Of two unstable ones,
/// the better is the one with flutter, about which the gear swings; otherwise the one with slower growth;
/// otherwise the one with the smaller residual.
void Race::keep_better(const Stage& stage) {
  if (!stage.is_stationary()) return;
  const auto rank = [](const Stage& one) {
    return std::tuple(!one.is_stationary(), !one.has_converged(), !one.flutters(), one.growth_rate,
                      one.imbalance());
  };
  if (rank(stage) < rank(best_)) best_ = stage;
}

}  // namespace netloft::automatic
