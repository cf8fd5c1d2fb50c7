// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/result_file.hpp"
#include "io/results/figures/make_result.hpp"

namespace netloft::results {

/// Facts of a run that are known when it begins.
struct RunContext {
  std::vector<std::string> command;
  std::string started;
  std::vector<const PluginOrigin*> plugins;
  std::string plan_text;
};
Origins make_origins(const scenes::LoadedScene& loaded, const RunContext& context);

/// The shape at the end of a stage of the solve.
struct StageShape {
  std::string name;       // "coarse: converged"
  std::vector<double> x;  // positions over all dofs
};

/// The shapes of a solve, which a Result does not contain.
struct SolvedShapes {
  const Solution& end;
  std::vector<StageShape> stages = {};  // stages before the end; empty: they were not saved
};

/// Writes the facts that are known when a run begins.
void write_inputs(formats::Tree& tree, const scenes::LoadedScene& loaded, const Result& result);

/// Writes the facts that are known when a run of any kind has ended, except shapes and forces.
void write_ending(formats::Tree& tree, const Result& result);

/// The path for a result with this outcome: `wanted`, or NAME.not-converged.hdf beside it if the existing
/// result has a better outcome. A worse result never replaces a better one.
std::filesystem::path name_beside_better(const std::filesystem::path& wanted, const std::string& outcome);

/// Writes a static result with its shapes into `file` (layout: io/formats/hdf5/LAYOUT.md) and completes it as
/// `result.path`.
void write_result(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                  const SolvedShapes& shapes, const Result& result);

}  // namespace netloft::results
