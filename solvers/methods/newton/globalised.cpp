// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/damping.hpp"
#include "solvers/methods/newton/direction.hpp"
#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/merit_steps.hpp"
#include "solvers/methods/newton/methods.hpp"
#include "solvers/methods/newton/nearly_definite.hpp"
#include "solvers/methods/newton/negative_curvature.hpp"
#include "solvers/methods/newton/round_off_steps.hpp"

namespace netloft::newton {

namespace {

/// If the line search accepts a t larger than this, the model of the step counts as good, otherwise as bad.
constexpr double kTrusted = 0.5;

/// Returns the damping μ for the next direction. μ falls if the step was accepted on the residual, or on the
/// merit with t > ½. μ is multiplied by 1/(2 t) if a shorter step was accepted on the merit, and rises if no
/// step was found. If the step was accepted on the slope, or if u moved along negative curvature only, μ
/// becomes the damping of the matrix of that step.
double damping_after(const Step& step, const DampingRange& range) {
  if (!step) return range.raised(step.damping);
  if (step.rule == Step::Rule::residual) return range.lowered(step.damping);
  if (step.rule != Step::Rule::energy) return step.damping;
  return step.length > kTrusted ? range.lowered(step.damping)
                                : range.raised(step.damping, kTrusted / step.length);
}

/// The globalised iteration of newton.hpp. It fails if no step is found with μ at `most_damping`, if no
/// matrix can be factorised, or if forces are undefined at the point.
class Globalised {
 public:
  Globalised(const Newton::Parameters& parameters, Problem& problem)
      : iterate_(problem),
        range_(parameters, problem.symmetric()),
        damping_(parameters.damping),
        nearly_definite_(range_),
        curvature_(parameters, problem),
        directions_(range_, problem, nearly_definite_),
        by_merit_(parameters, problem.size()),
        at_round_off_(parameters, problem, nearly_definite_, curvature_) {}

  Outcome run() {
    if (!iterate_.evaluate()) return Outcome::left_domain;
    const char* note = "";
    // `report` is false when the host stops the iteration: it has converged, or a limit is reached.
    for (bool is_first = true; iterate_.report(note); is_first = false) {
      if (!iterate_.split_residual()) return Outcome::left_domain;
      const Direction direction =
          is_first ? directions_.find_first(iterate_, damping_) : directions_.find(iterate_, damping_);
      if (!direction) return *direction.failure;
      const Step step = take_step(direction);
      if (!step && step.damping >= range_.most) return Outcome::step_too_short;
      damping_ = damping_after(step, range_);
      note = direction.note;
    }
    return Outcome::stopped;
  }

 private:
  Step take_step(const Direction& direction) {
    const bool is_at_round_off = iterate_.promises_round_off({direction.s});
    Step step =
        is_at_round_off ? at_round_off_.take(iterate_, direction) : by_merit_.take(iterate_, direction);
    const double energy = iterate_.energy();
    if (direction.nearly_definite) step.leaves_saddle = leave_saddle(direction.damping);
    if (!step && is_at_round_off) step = at_round_off_.fall_back(iterate_, direction.damping);
    // The energy is defined, because saddles are left only if all forces have a potential.
    if (step.leaves_saddle) by_merit_.add_gain(energy - iterate_.energy());
    if (step.rule == Step::Rule::energy || step.leaves_saddle) at_round_off_.reset_stall_count();
    return step;
  }

  /// Moves along negative curvature, (6) of newton.hpp, after a step by K + σ M, even if that step was not
  /// accepted. The factor of the point before the step is used, because the direction changes little in a
  /// step.
  bool leave_saddle(double sigma) {
    const auto v = curvature_.find_direction(iterate_.problem(), sigma);
    return v && curvature_.leave_along(*v, iterate_);
  }

  Iterate iterate_;
  const DampingRange range_;
  double damping_;
  NearlyDefinite nearly_definite_;
  NegativeCurvature curvature_;
  Directions directions_;
  MeritSteps by_merit_;
  RoundOffSteps at_round_off_;
};

}  // namespace

Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem) {
  return Globalised(parameters, problem).run();
}

}  // namespace netloft::newton
