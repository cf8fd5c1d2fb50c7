// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/studies/variables/distribution.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace netloft::studies {

/// A scene that describes a gear and conditions at which figures were measured.
struct CalibrationScene {
  std::string name;
  std::string file;  // path relative to the folder of the calibration file
  formats::Place place;
  std::vector<std::string> set;  // overrides in the syntax of `--set`
};

/// An unknown input of the scenes, with its prior distribution.
struct CalibrationVariable {
  Variable variable;
  Distribution distribution;
  std::vector<std::size_t> scenes;  // indices of the scenes in which the variable is set
  /// Whether the variable is set in all scenes; if not, its key `scenes` names the scenes.
  bool is_shared = true;
  double prior_mean() const;
  double prior_deviation() const;
};

/// A measured value of a figure (a number that the run of a scene reports). Value and deviation are texts
/// with units, because the unit of the figure is not known before the scene is read.
struct MeasuredFigure {
  std::size_t scene = 0;
  std::string figure;  // name of the figure: "gear/mouth/headline_height"
  formats::Place place, value_place;
  std::string value, deviation;
  bool is_held_back = false;
};

/// The contents of a calibration file (io/studies/CALIBRATION.md).
struct CalibrationFile {
  std::string name;         // name of the file without its extension
  double confidence = 0.9;  // probability that intervals and bands contain the true value
  std::vector<CalibrationScene> scenes;
  std::vector<CalibrationVariable> variables;
  std::vector<MeasuredFigure> measured;
};

/// Reads a calibration file. Errors are reported to `diagnostics`; if there are any, do not use the result.
CalibrationFile read_calibration_file(const std::filesystem::path& path, formats::Diagnostics& diagnostics);

}  // namespace netloft::studies
