// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/sweep/record.hpp"

#include <memory>

namespace netloft::studies {

/// The folder of the study, and the plugins and threads that solve an item.
struct PathContext {
  std::filesystem::path folder;  // the folder of the study
  Registry* registry = nullptr;
  runs::Watch watch = {};
  int threads = 1;  // threads of the assembly
};

/// Solves the points of an item one after another, along a branch of equilibria (branch.hpp). Points with
/// equal matrix patterns share one ordering and analysis. Returns nullopt if the user interrupts. Throws
/// StudyError if the item cannot be computed at all, for example because a file has changed since the study
/// was planned.
std::optional<ItemRecord> run_path(const Study& study, const StudyItem& item, const PathContext& context);

/// The scene of an item, with the changes of the study and of the item.
runs::CaseSource source_of(const Study& study, const StudyItem& item, const PathContext& context);

/// The first error in the diagnostics of a scene that could not be read.
std::string first_fault(const formats::Diagnostics& diagnostics);

/// All numbers that a scene reports for a solution.
std::vector<StudyFigure> figures_of(runs::PreparedScene& scene, const Solution& solution);

}  // namespace netloft::studies
