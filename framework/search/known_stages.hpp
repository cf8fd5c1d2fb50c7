// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/solution.hpp"
#include "framework/registry/registry.hpp"

#include <list>
#include <string>
#include <vector>

namespace netloft {

/// What a strategy asks for, but for how much work it may cost.
struct StageRequest {
  bool by_strategy = false;  // else by a solver
  std::string by;            // its type
  Values parameters;
  netloft_variant variant{};  // seen from the scene as it is written
  double tolerance = 0, path = 0;
  std::uint32_t iterations = 0, flags = 0;
  std::vector<double> start{};  // displacements of the unknowns
};

/// What came of it.
struct KnownStage {
  StageRequest asked;
  Solution solution;
  bool is_cut_off = false;  // by its budget: there is more to come
  // Of a strategy:
  bool has_solution = true;  // it solved some stage of its scene
  netloft_ending ending = NETLOFT_ENDED_NOT_CONVERGED;
  int unsettled = 0;  // stages within it that did not come to rest
};

/// Stages that have been solved in a search, so that none is solved twice. A strategy that was cut off is
/// called again from the same start: what it has solved costs next to nothing then, and the stage that was
/// cut off goes on where it ended. What a strategy does by methods of its own is not known, and done again.
///
/// Those that were not asked for longest are forgotten where all together would take more than `most`
/// numbers.
class KnownStages {
 public:
  explicit KnownStages(std::size_t most) : most_(most) {}

  /// Null: it has not been asked for, or is forgotten.
  const KnownStage* find(const StageRequest& request);
  /// In the place of what came of the same request before; without what it cost and how it went on.
  void keep(KnownStage stage);

 private:
  std::size_t most_, numbers_ = 0;
  std::list<KnownStage> stages_;  // in the order in which they were last asked for
};

}  // namespace netloft
