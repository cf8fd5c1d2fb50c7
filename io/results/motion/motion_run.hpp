// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/fold.hpp"
#include "io/results/file/write_result.hpp"
#include "io/runs/prepared_scene.hpp"

#include <cmath>
#include <optional>

namespace netloft::results {

/// What the scheme took, by energy_judge.hpp, over the outputs of this run: energy that no force has taken
/// and none has kept.
struct NumericalLoss {
  double lost = 0, given = 0;             // in all [J]
  double worst = 0, from = 0, until = 0;  // most between two outputs [J], their times [s]
  std::string node;                       // whose velocity changed most between them
  /// The scheme decides about more than a twentieth: no accuracy resolves the path that follows.
  bool is_large() const { return std::abs(lost) > 0.05 * given; }
  bool is_created() const { return lost < 0; }
};

/// The result of a motion.
struct MotionResult {
  MarchResult march;
  std::vector<NamedScalar> scalars;  // at the last output
  std::vector<NamedScalar> gear;     // at the last output; empty: no net plan
  // at the last output [J]; empty: no energy budget was kept
  std::vector<std::pair<std::string, double>> energies;
  std::optional<NumericalLoss> loss;  // none: no energy budget was kept
  std::vector<std::string> warnings;  // of boards that lay over or pushed inward at an output of this run
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
  std::function<void(const std::string&)> warn;                   // of what a person has to know now
  std::function<void(const IterationRecord&)> on_iteration = {};  // while the start is looked for
};

/// Marches through time as the case's analysis says, and writes every output into the journal NAME.hdf.part:
/// the picture, named results and the energy budget as series, and the state from which to continue. Makes
/// the result of it unless the march was interrupted. Throws FileError.
MotionResult run_motion(runs::PreparedScene& scene, const RunContext& context, const MotionOptions& options);

}  // namespace netloft::results
