// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/analysis/tension_newton.hpp"

namespace netloft::io {

/// How a scene is brought from a drawing to its equilibrium over softer ones.
struct TensionStages {
  double softest = 7e-4;  // share of all stiffness with which the drawing is solved
  /// At the most, of each part over the tension it had before: from the first by this ratio up to the last.
  double first = 5, ratio = 4.6, last = 2e4;
  double tolerance = 1e-9;  // of the scene itself: largest residual over the largest reaction
  double seconds = std::numeric_limits<double>::infinity();  // for all stages
  const std::atomic<bool>* interrupt = nullptr;
};

/// Where it ended, and every stage.
struct StagedSolution {
  bool arrived = false;
  std::vector<double> positions;  // of the nodes, 3 each [m]
  std::vector<Leg> legs;
};

/// Solves a scene soft at first, then with every part as stiff as a multiple of its own tension, then as it
/// is; tensions are unknowns of their own all along (tension_newton.hpp). A cap that is the same for all
/// parts leaves what carries little as stiff as it was; this one strains all by as much.
StagedSolution solve_in_stages(const Scene& scene, Registry& registry, MakeFactorisation make, int threads,
                               const TensionStages& stages = {});

}  // namespace netloft::io
