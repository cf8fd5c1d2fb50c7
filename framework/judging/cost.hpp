// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/assessment.hpp"

namespace netloft {

/// A stage: one solve by a strategy, of the scene itself or of an easier variant.
struct StageRecord {
  std::string name;    // "tension only"
  std::string solver;  // "newton/newton"
  std::size_t unknowns = 0;
  SolveStatus status = SolveStatus::not_converged;
  std::string reason;
  Statistics statistics;
  netloft_variant variant{};  // the variant of the scene that was solved
  double work = 0;            // work in Newton iterations of the scene (work.hpp)
};

/// Cost of a solution, and the stages (solves) that led to it.
struct Cost {
  Statistics statistics;            // the solver's own counts, and the time of all stages
  double work = 0;                  // of all stages, in Newton iterations of the scene (work.hpp)
  std::vector<StageRecord> stages;  // if there were several; `statistics` is then their sum

  /// Adds the cost of later stages.
  void add(const Cost& later);
  /// Adds the cost of earlier stages, which failed.
  void add_before(const Cost& earlier);
};

}  // namespace netloft
