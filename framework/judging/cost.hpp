// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/assessment.hpp"

namespace netloft {

/// One solve on the way to an answer: of the scene itself, or of an easier one.
struct StageRecord {
  std::string name;    // "tension only"
  std::string solver;  // "newton/newton"
  std::size_t unknowns = 0;
  SolveStatus status = SolveStatus::not_converged;
  std::string reason;
  Statistics statistics;
  netloft_variant variant{};  // of the scene that was solved
  double work = 0;            // in the units of work.hpp
};

/// What an answer cost, and by which stages it was found.
struct Cost {
  Statistics statistics;            // the solver's own counts, and the time of everything
  double work = 0;                  // of all stages, in the units of work.hpp
  std::vector<StageRecord> stages;  // if there were several; `statistics` is then their sum

  /// Adds what was spent after this.
  void add(const Cost& later);
  /// Adds what was spent before this, and in vain.
  void add_before(const Cost& earlier);
};

}  // namespace netloft
