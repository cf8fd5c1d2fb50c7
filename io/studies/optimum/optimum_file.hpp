// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/studies/variables/variable.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace netloft::studies {

/// A number of the scene that the optimisation may change within its interval.
struct OptimumVariable {
  Variable variable;
  // In the unit of the variable:
  std::optional<double> start = {};  // where the search begins; nullopt: as in the scene
  std::optional<double> step = {};   // the answer must be a whole multiple of it; nullopt: any number
};

/// Limits of a figure of the scene. They are texts, because the unit of the figure is not known before the
/// scene is read.
struct FigureLimits {
  std::string figure;  // name of the figure: "gear/mouth/headline_height"
  formats::Place place, low_place, high_place;
  std::string at_least, at_most;  // empty: no limit
};

/// The contents of a file for `netloft optimise` (io/studies/STUDY.md).
struct OptimumFile {
  std::string name;   // name of the file without its extension
  std::string scene;  // path of the scene, relative to the folder of the file
  formats::Place scene_place, set_place;
  std::vector<std::string> set;  // overrides in the syntax of `--set`
  std::vector<OptimumVariable> variables;
  std::string objective;  // name of the figure that is minimised or maximised
  std::string unit;       // unit in which it is reported
  formats::Place objective_place, unit_place;
  bool maximise = false;
  std::vector<FigureLimits> constraints;
  int solves = 60;  // limit of the number of solves
};

/// Reads the file. Errors are reported to `diagnostics`. After an error, the result contains only the parts
/// that could be read, and may be used only to find further errors (check_optimum).
OptimumFile read_optimum_file(const std::filesystem::path& path, formats::Diagnostics& diagnostics);

}  // namespace netloft::studies
