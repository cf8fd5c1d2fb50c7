// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/race.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft::automatic {

namespace {

// An equilibrium that is met twice and about which the gear swings as it grows is what there is: no motion
// rests near it, and it is reported as such.
constexpr int kTimesFluttering = 2;

bool is_better(const Stage& a, const Stage& b) {
  if (a.has_converged() != b.has_converged()) return a.has_converged();
  if (a.is_stationary() != b.is_stationary()) return a.is_stationary();
  return b.u.empty() || a.imbalance() < b.imbalance();
}

/// The start of the study; a little off it where elements have no force there, which shows no way.
Displacements start_with_forces(Study& study, const Options& options) {
  const Stage start = study.assess({.name = "the start"}, study.start());
  if (start.load > 0 || start.is_stationary()) return study.start();
  return perturbed(study.start(), options.perturbation * study.element_size());
}

/// By at most a fraction of an element, to the side that `side` says.
Displacements along(const Stage& saddle, double length, double side) {
  double largest = 0;
  for (const double g : saddle.growing) largest = std::max(largest, std::abs(g));
  if (!(largest > 0) || !std::isfinite(largest)) return perturbed(saddle.u, length, side > 0 ? 0 : 1);
  Displacements u = saddle.u;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += side * length / largest * saddle.growing[i];
  return u;
}

}  // namespace

Race::Race(Study& study, const Options& options)
    : study_(study), options_(options), start_(start_with_forces(study, options)) {}

Stage Race::run() {
  for (int turn = 0; turn < options_.starts && !is_decided(); ++turn) {
    if (turn > 0) start_ = perturbed(start_, options_.far * study_.element_size(), turn);
    run_from_start();
  }
  return best_;
}

void Race::run_from_start() {
  runners_.clear();
  for (const Attempt& attempt : attempts_for(study_, options_)) runners_.push_back({attempt, {}});
  const auto has_ended = [](const Runner& r) { return r.has_ended; };
  for (double slice = options_.slice; !std::all_of(runners_.begin(), runners_.end(), has_ended);
       slice *= options_.growth)
    for (Runner& runner : runners_) {
      if (is_decided()) return;
      if (!runner.has_ended) run_slice(runner, slice);
    }
}

bool Race::is_decided() const {
  return best_.has_converged() || fluttering_ >= kTimesFluttering || study_.work_left() == 0;
}

void Race::run_slice(Runner& runner, double slice) {
  const double work = std::min(slice, study_.work_left());
  const Ask ask{.name = runner.attempt.name, .work = work};
  const bool goes_on = !runner.from.empty();
  Stage stage = goes_on
                    ? study_.call(runner.attempt.goes_on_by, "", ask, std::move(runner.from))
                    : study_.call(runner.attempt.strategy, runner.attempt.parameters.c_str(), ask, start_);
  runner.has_ended = stage.ending != Ending::out_of_work || stage.spent == 0;
  const bool was_cut_off = !runner.has_ended && stage.load > 0;
  runner.from = was_cut_off ? stage.u : Displacements{};
  fluttering_ += stage.flutters();
  if (stage.ending == Ending::unstable && !stage.flutters() && study_.work_left() > 0)
    stage = leave_saddle(study_, options_, std::move(stage), work);
  keep_better(with_compensated_positions(study_, options_, std::move(stage)));
}

void Race::keep_better(Stage stage) {
  const bool is_known =
      stage.is_stationary() || stage.load > 0;  // else no stage of the scene itself was solved
  if (is_known && is_better(stage, best_)) best_ = std::move(stage);
}

Stage with_compensated_positions(Study& study, const Options& options, Stage stage) {
  const bool is_rounded =
      stage.load > 0 && stage.residual <= stage.rounding && stage.ending != Ending::unstable;
  if (!is_rounded || study.remembers() || study.work_left() == 0 || is_left_out(options, "compensated"))
    return stage;
  Stage next = study.solve({.name = "with compensated positions", .compensated = true}, stage.u);
  return next.has_converged() && next.residual <= stage.residual ? std::move(next) : std::move(stage);
}

Stage leave_saddle(Study& study, const Options& options, Stage saddle, double work) {
  const double length = options.perturbation * study.element_size();
  const char* const strategy = study.conservative() ? "direct" : "pseudo-time";
  for (const double side : {1.0, -1.0}) {
    Stage next = study.call(
        strategy, "", {.name = "off an unstable equilibrium", .work = std::min(work, study.work_left())},
        along(saddle, length, side));
    if (next.has_converged() || study.work_left() == 0) return next.has_converged() ? next : saddle;
    if (next.ending == Ending::unstable) saddle = std::move(next);
  }
  return saddle;
}

}  // namespace netloft::automatic
