// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/case/case.hpp"
#include "io/sweep/record.hpp"

#include <memory>

namespace netloft::io {

/// Where and with what an item is solved.
struct PathContext {
  std::filesystem::path folder;  // of the study
  Registry* registry = nullptr;
  const std::atomic<bool>* interrupt = nullptr;
  int threads = 1;  // of the assembly
};

/// Solves the points of an item one after the other. A point starts from the equilibrium of the one before,
/// as the last two lead on, by the solver of the analysis alone; where that does not converge, and at the
/// first point, it is found anew by the strategy of the analysis. All of them order and analyse their
/// matrices once, if these have one pattern. Nothing if the user interrupts. Throws StudyError where the item
/// cannot be computed at all, such as when a file has changed since the study was planned.
std::optional<ItemRecord> run_path(const Study& study, const StudyItem& item, const PathContext& context);

/// The scene of a point, as the study sets it.
CaseSource source_of_point(const Study& study, const StudyItem& item, const StudyPoint& point,
                           const PathContext& context);

/// All numbers that a case reports at a solution.
std::vector<StudyFigure> figures_of(Case& the_case, const Solution& solution);

}  // namespace netloft::io
