// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/studies/sweep/study.hpp"

namespace netloft::studies {

/// Properties of the scenes of a study, found before it is planned.
struct CheckedScenes {
  bool refused = false;                                    // a plugin is missing or was refused
  std::vector<std::pair<std::string, std::string>> files;  // path and hash of all files read
  std::vector<std::string> figures;                        // names of all figures that the scenes report
};

/// Reads the scene with every value of every variable once (both ends of the interval for a sampled
/// variable), while the other variables have their first value. Errors are reported in the study file, at the
/// variable that causes them or at `scene`. Figures that the scene does not report are errors, too. Left out
/// are variables that were not read without errors, and variables that made a scene unreadable, once this is
/// reported, so that further errors are found.
CheckedScenes check_scenes(const StudyFile& file, const std::filesystem::path& folder, Registry& registry,
                           formats::Diagnostics& diagnostics);

}  // namespace netloft::studies
