// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/assessment.hpp"

namespace netloft {

/// A stage: one solve by a strategy, of the scene itself or of an easier variant.
struct StageRecord {
  std::string name;    // such as "tension only"
  std::string solver;  // such as "newton/newton"
  std::size_t unknowns = 0;
  SolveStatus status = SolveStatus::not_converged;
  std::string reason;
  Statistics statistics;
  netloft_variant variant{};  // the variant of the scene that was solved
  double work = 0;            // work in Newton iterations of the scene (work.hpp)
};

/// Cost of a solution, and the stages (solves) that led to it.
struct Cost {
  // The sum over all stages. The times include the checks of the host after the last stage, the counts do
  // not.
  Statistics statistics;
  double work = 0;                  // work of all stages, in Newton iterations of the scene (work.hpp)
  std::vector<StageRecord> stages;  // in the order in which they ran; one if the strategy solved only once

  /// Adds the cost of later stages.
  void add(const Cost& later);
  /// Adds the cost of earlier stages, which failed.
  void add_before(const Cost& earlier);
};

}  // namespace netloft
