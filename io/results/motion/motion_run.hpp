// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/fold.hpp"
#include "io/results/file/write_result.hpp"
#include "io/runs/prepared_scene.hpp"

#include <optional>

namespace netloft::results {

/// The result of a motion, and the march that made it.
struct MotionResult {
  Result result;  // its path is the .part file if the march was interrupted
  MarchResult march;
};

/// Options for running a motion.
struct MotionOptions {
  std::filesystem::path output;
  bool resume = false;                            // continue from the output's .part
  std::optional<std::vector<double>> start = {};  // initial displacements; empty: those of the scene
  std::string identity;                           // identifies the scene and the changes on the command line
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const StepRecord&)> on_step;
  std::function<void(const std::string&)> warn;                   // reports a problem while the motion runs
  std::function<void(const IterationRecord&)> on_iteration = {};  // called during the search for the start
};

/// Marches through time by the analysis of the case, and writes every output into the journal NAME.hdf.part:
/// shapes and fields, named results and the energy budget as series, and the state from which to continue.
/// Makes the result file from it unless the march was interrupted. Throws FileError.
MotionResult run_motion(runs::PreparedScene& scene, const RunContext& context, const MotionOptions& options);

}  // namespace netloft::results
