// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace netloft::results {

/// A number of a result, with the errors that the file states for it.
struct ResultNumber {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
  double value = kUnknown, solver_error = kUnknown, mesh_error = kUnknown;
};

/// A file that the scene was read from.
struct InputText {
  std::string path, text;
};

/// The contents of a result file, and the inputs it was computed from (io/formats/hdf5/LAYOUT.md).
struct ResultSummary {
  std::string path;
  std::string outcome, sentence;  // empty: the file has no status because the run has not ended
  bool has_gear = false;
  std::map<std::string, ResultNumber> numbers;  // "results/lowest_z", "gear/mouth/area", "held/warp/x"
  std::string version;                          // of the program
  std::vector<std::string> command;             // one argument each
  std::vector<InputText> files;                 // the first is the scene
  std::map<std::string, std::string> plugins;   // name -> hash

  /// Whether the numbers are those of a completed computation.
  bool is_answer() const { return outcome == "converged" || outcome == "finished"; }
};

/// Throws FileError with a sentence if the file cannot be read or is no result.
ResultSummary read_summary(const std::filesystem::path& path);

}  // namespace netloft::results
