// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/fold.hpp"
#include "io/results/file/write_result.hpp"
#include "io/runs/prepared_scene.hpp"

#include <optional>

namespace netloft::results {

/// The result of a motion, and the march that made it.
struct MotionResult {
  Result result;  // its path is that of the .part if the march was interrupted
  MarchResult march;
};

/// Options for running a motion.
struct MotionOptions {
  std::filesystem::path output;
  bool resume = false;                            // continue from the output's .part
  std::optional<std::vector<double>> start = {};  // displacements to begin from; none: as the scene says
  std::string identity;                           // identifies the scene with the changes of the command line
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const StepRecord&)> on_step;
  std::function<void(const std::string&)> warn;                   // reports a problem while the motion runs
  std::function<void(const IterationRecord&)> on_iteration = {};  // while the start is looked for
};

/// Marches through time as the case's analysis says, and writes every output into the journal NAME.hdf.part:
/// the picture, named results and the energy budget as series, and the state from which to continue. Makes
/// the result of it unless the march was interrupted. Throws FileError.
MotionResult run_motion(runs::PreparedScene& scene, const RunContext& context, const MotionOptions& options);

}  // namespace netloft::results
