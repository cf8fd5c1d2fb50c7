// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/analysis/case.hpp"
#include "io/hdf5/series_file.hpp"
#include "io/report/write_result.hpp"

namespace netloft::io {

/// What came of going through time.
struct MotionResult {
  MarchResult march;
  std::vector<NamedScalar> scalars;                      // at the last output
  std::vector<NamedScalar> gear;                         // at the last output; empty: no net plan
  std::vector<std::pair<std::string, double>> energies;  // at the last output [J]; empty: no account was kept
  std::size_t outputs = 0;
  double resumed_from = 0;  // [s]
  std::string output_file;  // the .part if it was interrupted
};

/// How a motion is run.
struct MotionOptions {
  std::filesystem::path output;
  bool resume = false;   // go on from the output's .part
  std::string identity;  // of the scene as it was changed on the command line
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const StepRecord&)> on_step;
};

/// Goes through time as the case's analysis says, and writes every output: the picture, named results and the
/// energy budget as series, and what to go on from. Finishes the file unless it was interrupted.
/// Throws FileError.
MotionResult run_motion(Case& the_case, const RunContext& context, const MotionOptions& options);

}  // namespace netloft::io
