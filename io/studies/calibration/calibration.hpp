// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/calibration/scene_model.hpp"

namespace netloft::studies {

/// The result of a calibration: a fit, or the reason why there is none.
struct Calibration {
  CalibrationFile file;
  std::vector<Measurement> measured;  // values in the order of the file, each in the unit of its figure
  std::vector<std::string> units;
  Fit fit;                         // rows: first the fitted measurements, then those that were held back
  std::vector<std::size_t> order;  // for each row of `fit`, the index of its measurement in the file
  bool is_interrupted = false;     // true: the user interrupted
  int solves = 0;
  double cpu_seconds = 0;
  std::vector<std::string> unstable;  // scenes with an unstable equilibrium at the fitted parameters
  std::string trouble;  // if the fit did not converge: why the scene that failed last has no equilibrium

  /// Half width of the intervals of parameters and of the bands of predictions, in standard deviations.
  double width() const;
};

/// Fits the parameters to the measurements that are not held back, and predicts all measurements.
Calibration calibrate(CalibrationFile file, const CheckedCalibration& checked,
                      const std::filesystem::path& folder, Registry& registry, const runs::Watch& watch,
                      const OnSolve& on_solve = {});

/// The report of a calibration as text, and as one JSON object.
std::string calibration_text(const Calibration& calibration);
std::string calibration_json(const Calibration& calibration);

}  // namespace netloft::studies
