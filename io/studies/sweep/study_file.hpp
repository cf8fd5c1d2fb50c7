// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/document.hpp"
#include "io/studies/sweep/unit_points.hpp"
#include "io/studies/variables/distribution.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace netloft::studies {

/// How listed values of several variables are combined. grid: all combinations; list: the first value of
/// each, the second value of each, and so on.
enum class Combination { grid, list };

struct DesignVariable {
  Variable variable;
  Distribution distribution;  // distribution of a variable with an interval
  bool is_in_path = false;
  bool is_sound = true;  // whether it was read without errors
  bool is_sampled() const { return variable.interval.has_value(); }
};

/// A study file (STUDY.md): the scene, its variables, and the combination of their values.
struct StudyFile {
  std::string name;   // name of the file without its extension
  std::string scene;  // path of the scene, relative to the folder of the file
  formats::Place scene_place;
  std::vector<std::string> set;  // overrides of all points, in the syntax of `--set`
  formats::Place set_place;
  std::vector<DesignVariable> variables;  // variables in the order of the file
  Combination combination = Combination::grid;
  Sampling sampling = Sampling::latin_hypercube;
  std::size_t samples = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> figures;  // figures to record; empty: all
  std::vector<formats::Place> figure_places;
};

/// Reads a study file. Errors are reported to `diagnostics`; if there are any, the result may be used only to
/// find further errors (check_study.hpp).
StudyFile read_study_file(const std::filesystem::path& path, formats::Diagnostics& diagnostics);

}  // namespace netloft::studies
