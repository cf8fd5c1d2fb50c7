// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/journey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft {

namespace {

// An easier scene only gives a start: it need not be exact.
constexpr double kLegTolerance = 1e-4;
// Relaxation only brings near; where things stick and slide, so near that they do so no longer.
constexpr double kRelaxed = 1e-2, kRelaxedToStick = 1e-5;
// Stiffness grows from so many times the largest load, tenfold at first; after stages of few iterations by
// larger steps, after one that does not arrive by smaller ones. What stands at a saddle goes back so far.
constexpr double kStiffer = 10, kSoftest = 30, kMostStiffer = 100, kLeastStiffer = 1.3, kBack = 1e-3;
constexpr int kShortStage = 15;
constexpr double kWeakest = 1e-9;
// A ramp of the current gives up at steps of this share.
constexpr double kShortestRamp = 1.0 / 64;
// The motion may take so many steps for each iteration that the scene itself may take, but no more than so
// many, and so much of the time that all ways together are worth.
constexpr int kMotionSteps = 5, kMostMotionSteps = 20000;
constexpr double kMotionPatience = 0.4;

}  // namespace

/// From a little aside of a saddle, where forces have no energy, to where that moves; else there itself, or
/// if it is stiff, by way of softer ones. Whoever only looks does not move from there.
Journey::Displacements Journey::away_from(const Solution& saddle) {
  Displacements aside = saddle.growing.empty() ? shaken(saddle.u, kLeaveShare) : grown(saddle);
  if (!is_conservative_ && may_move_)
    if (const auto moved = move(aside)) return moved->u;
  if (!is_conservative_ || !is_stiff()) return aside;
  const double stiffest = largest_stiffness(scene_, registry_);
  return stiffened(std::move(aside), kBack * stiffest, stiffest);
}

std::optional<Journey::Displacements> Journey::over_nothing(const Displacements& start, const Solution&) {
  return start;
}

/// A start without forces shows no way.
std::optional<Journey::Displacements> Journey::over_shaking(const Displacements& start,
                                                            const Solution& best) {
  if (best.balance.scale > 0) return {};
  Displacements u = start;
  u.resize(best.u.size());
  return shaken(std::move(u), kLeaveShare);
}

/// Every unknown aside by up to a share of an element's size, by fractions of multiples of the golden ratio:
/// no symmetry survives it.
Journey::Displacements Journey::shaken(Displacements u, double share) const {
  constexpr double kGolden = 0.61803398874989485, kSilver = 0.41421356237309505;
  const double size = StaticProblem(assembler_, options_.make, options_.limits).element_size();
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double multiple = kGolden * static_cast<double>(i + 1) + kSilver * turn_;
    u[i] += share * size * (2 * (multiple - std::floor(multiple)) - 1);
  }
  return u;
}

std::optional<Journey::Displacements> Journey::over_own_start(const Displacements& start, const Solution&) {
  return options_.own_start.find(start, seconds_left(), legs_);
}

/// Aside along what grows, by a share of an element's size; the next time to the other side.
Journey::Displacements Journey::grown(const Solution& s) {
  double largest = 0;
  for (const double g : s.growing) largest = std::max(largest, std::abs(g));
  const double size = StaticProblem(assembler_, options_.make, options_.limits).element_size();
  if (!(largest > 0) || !std::isfinite(largest)) return shaken(s.u, kLeaveShare);
  side_ = -side_;
  const double share = side_ * kLeaveShare * size / largest;
  Displacements u = s.u;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += share * s.growing[i];
  return u;
}

std::optional<Journey::Displacements> Journey::over_tension_only(const Displacements& start,
                                                                 const Solution&) {
  const auto easier = without_compression(scene_, registry_);
  if (!easier) return {};
  return solve_leg("tension only", *easier, options_.solver, start, kLegTolerance).u;
}

std::optional<Journey::Displacements> Journey::over_stiffness(const Displacements& start, const Solution&) {
  const double stiffest = largest_stiffness(scene_, registry_);
  const double load = StaticProblem(assembler_, options_.make, options_.limits).driving_load().largest;
  const double softest = std::max(kSoftest * load, kWeakest * stiffest);
  if (stiffest <= softest) return {};
  return stiffened(start, softest, stiffest);
}

/// From where all stiffness is at most `cap` to where it is just below `stiffest` [N].
Journey::Displacements Journey::stiffened(Displacements u, double cap, double stiffest) {
  double done = 0;
  for (double factor = kStiffer; cap < stiffest && !out_of_time(); cap = done * factor) {
    const Solution s = solve_stage(u, cap);
    if (is_stationary(s)) {
      u = s.u, done = cap;
      if (s.books.iterations <= kShortStage) factor = std::min(factor * std::sqrt(kStiffer), kMostStiffer);
    } else if (done == 0 || (factor = std::sqrt(factor)) < kLeastStiffer) {
      return s.u;
    }
  }
  return u;
}

/// What is pressed may give way while it is soft.
Solution Journey::solve_stage(const Displacements& start, double cap) {
  const std::string name = "stiffness up to " + std::to_string(std::llround(cap)) + " N";
  const Scene softer = softened(scene_, registry_, cap);
  const Solution s = solve_leg(name, softer, options_.solver, start, kLegTolerance);
  if (s.status != SolveStatus::unstable) return s;
  return solve_leg(name + ", shaken", softer, options_.solver, shaken(s.u, kLeaveShare), kLegTolerance);
}

std::optional<Journey::Displacements> Journey::over_current(const Displacements& start, const Solution&) {
  if (!scene_.current.flows()) return {};
  Displacements u =
      solve_leg("still water", with_current(scene_, 0), options_.solver, start, kLegTolerance).u;
  double share = 0, step = 0.25;
  while (share + step < 1 && !out_of_time()) {
    const Solution s = solve_leg("current x " + std::to_string(share + step),
                                 with_current(scene_, share + step), options_.solver, u, kLegTolerance);
    if (is_stationary(s))
      share += step, u = s.u, step *= 2;
    else if ((step *= 0.5) < kShortestRamp)
      return {};
  }
  return u;
}

std::optional<Journey::Displacements> Journey::over_relaxation(const Displacements& start, const Solution&) {
  const auto relaxation = other_solver("relaxation");
  if (!relaxation) return {};
  if (sticks()) leg_patience_ = patience_;
  relaxed_ = solve_leg("relaxation", scene_, *relaxation, start, sticks() ? kRelaxedToStick : kRelaxed).u;
  return relaxed_;
}

std::optional<Journey::Displacements> Journey::over_motion(const Displacements& start, const Solution& best) {
  if (flutters(best)) return {};
  const auto s = move(start);
  if (!s) return {};
  moved_ = is_stationary(*s) || s->is_restless ? Displacements{} : s->u;
  return s->u;
}

/// To where it comes to rest when nothing but its linear stiffness resists it.
std::optional<Solution> Journey::move(const Displacements& start) {
  auto motion = other_solver("ptc");
  if (!motion) return {};
  motion->parameters["method"] = std::string("implicit");
  const double before = std::exchange(leg_patience_, kMotionPatience * patience_);
  leg_way_ = kLongestWay;
  Solution s =
      solve_leg("motion", scene_, *motion, start, options_.limits.tolerance,
                std::min(options_.limits.iterations, kMostMotionSteps / kMotionSteps) * kMotionSteps);
  leg_patience_ = before, leg_way_ = Limits{}.way;
  ++motions_, restless_ += s.is_restless;
  return s;
}

std::optional<Journey::Displacements> Journey::over_more_motion(const Displacements&, const Solution& best) {
  return moved_.empty() ? std::nullopt : over_motion(Displacements(moved_), best);
}

}  // namespace netloft
