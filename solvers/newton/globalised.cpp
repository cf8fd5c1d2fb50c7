// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "solvers/newton/direction.hpp"
#include "solvers/newton/globalisation.hpp"
#include "solvers/newton/iterate.hpp"
#include "solvers/newton/methods.hpp"
#include "solvers/newton/negative_curvature.hpp"

namespace netloft::newton {

namespace {

// Less damping than this no longer matters.
constexpr double kSmallestDamping = 1e-12;

double raised(double damping, double factor) { return std::clamp(damping * factor, 1e-6, kLargestDamping); }

/// A whole step means that the model is trusted: μ falls tenfold. After a part t of one μ becomes μ/2t: the
/// model reaches too far.
double adapted(double damping, const Step& step) {
  if (!step) return damping;
  if (step.length < 1) return raised(damping, 0.5 / step.length);
  return damping < 10 * kSmallestDamping ? 0 : 0.1 * damping;
}

class Globalised {
 public:
  Globalised(const Newton::Parameters& parameters, Problem& problem)
      : iterate_(problem),
        curvature_(problem),
        directions_(problem, curvature_),
        globalisation_(parameters),
        damping_(parameters.damping) {}

  Outcome run() {
    if (!iterate_.evaluate()) return Outcome::left_domain;
    const char* note = "";
    for (bool first = true; iterate_.report(note); first = false) {
      if (!iterate_.split_residual()) return Outcome::left_domain;
      const auto direction = find_direction(first);
      if (!direction) return Outcome::linear_solve;
      note = direction->note;
      const Step step = globalisation_.take(iterate_, *direction);
      damping_ = adapted(direction->damping, step);
      if (direction->nearly_definite && leave_saddle(direction->damping)) continue;
      if (step) continue;
      if (damping_ >= kLargestDamping) return Outcome::step_too_short;
      damping_ = raised(damping_, 16);
    }
    return Outcome::stopped;
  }

 private:
  std::optional<Direction> find_direction(bool is_first) {
    if (is_first)
      if (auto found = directions_.find_short_undamped(iterate_)) return found;
    return directions_.find(iterate_, damping_);
  }

  /// (6), after the step by K + σ M: with the factor that gave it, from where it has led. The step goes along
  /// the valley and does not change by much across which direction the valley is a ridge.
  bool leave_saddle(double sigma) {
    const auto v = curvature_.find_direction(iterate_.problem(), sigma);
    return v && curvature_.leave_along(*v, iterate_);
  }

  Iterate iterate_;
  NegativeCurvature curvature_;
  Directions directions_;
  Globalisation globalisation_;
  double damping_;
};

}  // namespace

Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem) {
  return Globalised(parameters, problem).run();
}

}  // namespace netloft::newton
