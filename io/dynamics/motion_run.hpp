// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/case/case.hpp"
#include "io/hdf5/fold.hpp"
#include "io/report/write_result.hpp"

#include <optional>

namespace netloft::io {

/// The result of a motion.
struct MotionResult {
  MarchResult march;
  std::vector<NamedScalar> scalars;  // at the last output
  std::vector<NamedScalar> gear;     // at the last output; empty: no net plan
  // at the last output [J]; empty: no energy budget was kept
  std::vector<std::pair<std::string, double>> energies;
  std::size_t outputs = 0;
  double resumed_from = 0;  // [s]
  std::string output_file;  // the .part if it was interrupted
};

/// Options for running a motion.
struct MotionOptions {
  std::filesystem::path output;
  bool resume = false;                            // continue from the output's .part
  std::optional<std::vector<double>> start = {};  // displacements to begin from; none: as the scene says
  std::string identity;                           // identifies the scene with the changes of the command line
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const StepRecord&)> on_step;
  std::function<void(const std::string&)> warn;  // of what a person has to know now
};

/// Marches through time as the case's analysis says, and writes every output into the journal NAME.hdf.part:
/// the picture, named results and the energy budget as series, and the state from which to continue. Makes
/// the result of it unless the march was interrupted. Throws FileError.
MotionResult run_motion(Case& the_case, const RunContext& context, const MotionOptions& options);

}  // namespace netloft::io
