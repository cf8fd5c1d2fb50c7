// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/tension_stages.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

// What carries nothing keeps this share of what the busiest part may have.
constexpr double kLeastTension = 1e-4;
// Whoever calls has a solver for what is not there by then.
constexpr int kLastIterations = 30;

TensionStage first_stage(const TensionStages& stages, std::size_t parts) {
  TensionStage stage;
  stage.name = "soft, from the start";
  stage.share.assign(parts, stages.softest);
  stage.from_afar = true, stage.damping = 0.2, stage.farthest_turn = 7, stage.tolerance = 0.15;
  return stage;
}

/// Shares that leave no part stiffer than a multiple of its tension.
std::vector<double> shares(const TensionNewton& newton, double multiple) {
  const std::vector<double> tension = newton.tensions_by_part(), &stiffness = newton.stiffness_by_part();
  const double least = kLeastTension * *std::max_element(tension.begin(), tension.end());
  std::vector<double> share(tension.size(), 1.0);
  for (std::size_t p = 0; p < share.size(); ++p)
    if (stiffness[p] > 0) share[p] = std::min(1.0, multiple * std::max(tension[p], least) / stiffness[p]);
  return share;
}

TensionStage next_stage(std::vector<double> share, double multiple) {
  TensionStage stage;
  stage.name = "stiffness up to " + std::to_string(std::llround(multiple)) + " x tension";
  stage.share = std::move(share);
  stage.damping = 9e-5, stage.farthest_turn = 0.25, stage.settled_turn = 1;
  stage.tolerance = 5;
  return stage;
}

TensionStage last_stage(double tolerance, std::size_t parts) {
  TensionStage stage = next_stage(std::vector<double>(parts, 1.0), 0);
  stage.name = "as it is, by tensions";
  stage.damping = 2e-5, stage.settled_turn = 0, stage.tolerance = tolerance,
  stage.iterations = kLastIterations;
  return stage;
}

}  // namespace

StagedSolution solve_in_stages(const Scene& scene, Registry& registry, MakeFactorisation make, int threads,
                               const TensionStages& stages) {
  TensionNewton newton(scene, registry, std::move(make), threads);
  StagedSolution solution;
  const double begun = wall_seconds();
  const auto run = [&](TensionStage stage) {
    stage.seconds = stages.seconds - (wall_seconds() - begun), stage.interrupt = stages.interrupt;
    solution.legs.push_back(newton.solve(stage));
  };
  run(first_stage(stages, scene.parts.size()));
  for (double multiple = stages.first; multiple < stages.last; multiple *= stages.ratio)
    run(next_stage(shares(newton, multiple), multiple));
  run(last_stage(stages.tolerance, scene.parts.size()));
  solution.arrived = solution.legs.back().status == SolveStatus::converged;
  solution.positions = newton.positions();
  return solution;
}

}  // namespace netloft::io
