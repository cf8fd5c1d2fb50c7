// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/solution.hpp"
#include "framework/registry/registry.hpp"

#include <list>
#include <string>
#include <vector>

namespace netloft {

/// The request of a strategy for a stage (one solve of the scene or of an easier variant), without the work
/// budget and the name of the stage.
struct StageRequest {
  bool by_strategy = false;  // whether a strategy solves the stage; otherwise a solver does
  std::string by;            // type of the strategy or solver
  Values parameters;
  netloft_variant variant{};  // variant relative to the original scene
  double tolerance = 0, path = 0;
  std::uint32_t iterations = 0, flags = 0;
  std::vector<double> start{};  // displacements of the unknowns
};

/// The result of a request.
struct KnownStage {
  StageRequest request;
  Solution solution;
  bool is_cut_off = false;  // whether the stage ended because its budget was used up, and can be continued
  // For a strategy only:
  bool has_solution = true;  // whether the strategy solved some stage of its own scene
  netloft_ending ending = NETLOFT_ENDED_NOT_CONVERGED;
  int unsettled = 0;  // how many stages of the strategy did not come to rest
};

/// Stores the results of stages in a search, so that no stage is solved twice. A strategy that ran out of
/// work is called again from the same start: it repeats its stages at next to no cost, and the stage in which
/// the work ran out continues from its final point. Methods that a strategy runs by itself are not stored;
/// they run again.
///
/// If all results together have more than `most` numbers, those whose last request is the longest ago are
/// discarded.
class KnownStages {
 public:
  explicit KnownStages(std::size_t most) : most_(most) {}

  /// The stored result of this request, or nullptr if there is none.
  const KnownStage* find(const StageRequest& request);
  /// Stores a result, but not its cost and history. It replaces an earlier result of the same request.
  void keep(KnownStage stage);

 private:
  std::size_t most_, numbers_ = 0;
  std::list<KnownStage> stages_;  // results in the order of their last request
};

}  // namespace netloft
