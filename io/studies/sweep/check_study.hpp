// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/studies/sweep/study.hpp"

namespace netloft::studies {

/// Facts about the scenes of a study, found before the study is planned.
struct CheckedScenes {
  bool refused = false;                                    // true: a plugin is missing or was rejected
  std::vector<std::pair<std::string, std::string>> files;  // path and hash of all files read
  std::vector<std::string> figures;                        // names of all figures that the scenes report
};

/// Reads the scene once for every value of every variable (both ends of the interval for a sampled variable),
/// with the other variables at their first value. Errors are reported in the study file, at the variable that
/// causes them or at the key `scene`. A figure of the study that the scene does not report is also an error.
/// A variable that cannot be read, or that makes the scene unreadable, is left out after its error is
/// reported, so that errors of other variables are found as well.
CheckedScenes check_scenes(const StudyFile& file, const std::filesystem::path& folder, Registry& registry,
                           formats::Diagnostics& diagnostics);

}  // namespace netloft::studies
