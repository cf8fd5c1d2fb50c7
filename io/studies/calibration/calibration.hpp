// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/calibration/scene_model.hpp"

namespace netloft::studies {

/// A calibration that was done, or why not.
struct Calibration {
  CalibrationFile file;
  std::vector<Measurement> measured;  // in the order of the file, in the units of the figures
  std::vector<std::string> units;
  Fit fit;                         // its rows: what took part, then what was held back
  std::vector<std::size_t> order;  // the file's row of each row of `fit`
  bool is_interrupted = false;     // by the user
  int solves = 0;
  double cpu_seconds = 0;
  std::vector<std::string> unstable;  // scenes whose equilibrium at the end is not stable
  std::string trouble;                // of the last scene that had no answer, where the fit did not converge

  /// Half width of intervals and bands over the deviation.
  double width() const;
};

/// Fits what takes part, and predicts the rest.
Calibration calibrate(CalibrationFile file, const CheckedCalibration& checked,
                      const std::filesystem::path& folder, Registry& registry, const runs::Watch& watch,
                      const OnSolve& on_solve = {});

/// For people, and as one JSON object.
std::string calibration_text(const Calibration& calibration);
std::string calibration_json(const Calibration& calibration);

}  // namespace netloft::studies
