// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/studies/sweep/study.hpp"

namespace netloft::studies {

/// Properties of the scenes of a study, found before it is planned.
struct CheckedScenes {
  bool refused = false;                                    // a plugin is missing or was refused
  std::vector<std::pair<std::string, std::string>> files;  // path and hash of all that was read
  std::vector<std::string> figures;                        // names of all that they report
};

/// Reads the scene with every value of every variable once, the other variables at their first value, those
/// that are sampled at both ends. What is wrong is shown in the study file: at the variable that is to blame,
/// or at `scene`. Figures that the scene does not report are an error, too. Variables that were not read
/// without errors are left out, and so are, once they are reported, those that are to blame for a scene that
/// cannot be read: what else is wrong is reported with them.
CheckedScenes check_scenes(const StudyFile& file, const std::filesystem::path& folder, Registry& registry,
                           formats::Diagnostics& diagnostics);

}  // namespace netloft::studies
