// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/fold.hpp"
#include "io/results/file/write_result.hpp"
#include "io/runs/prepared_scene.hpp"

#include <optional>

namespace netloft::results {

/// The result of a motion, and the record of the time integration that made it.
struct MotionResult {
  Result result;  // result.path is NAME.hdf.part if the motion was interrupted
  MarchResult march;
};

/// Options for running a motion.
struct MotionOptions {
  std::filesystem::path output;
  bool resume = false;                            // continue from NAME.hdf.part
  std::optional<std::vector<double>> start = {};  // displacements at the start; nullopt: those of the scene
  // Identifies the scene with its changes; a run is resumed only if this text is the same.
  std::string identity;
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const StepRecord&)> on_step;
  std::function<void(const std::string&)> warn;  // reports a problem while the motion runs
  // Called while the equilibrium at the start is searched.
  std::function<void(const IterationRecord&)> on_iteration = {};
};

/// Integrates the motion of the scene in time, as its table [analysis] says, and writes every output into the
/// file NAME.hdf.part: shapes and fields, the named results and the energy budget as series, and the state
/// from which to resume. When the motion has ended, makes the result file from NAME.hdf.part; after an
/// interruption, NAME.hdf.part remains. Throws FileError.
MotionResult run_motion(runs::PreparedScene& scene, const RunContext& context, const MotionOptions& options);

}  // namespace netloft::results
