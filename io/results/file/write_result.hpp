// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/result_file.hpp"
#include "io/results/figures/run_result.hpp"

namespace netloft::results {

/// Facts of a run that are not part of its result.
struct RunContext {
  std::vector<std::string> command;
  std::string started;
  std::vector<const PluginOrigin*> plugins;
  std::string plan_text;
};

/// Writes the inputs of a run, which are known when it begins.
void write_inputs(formats::Tree& tree, const scenes::LoadedScene& loaded, const RunContext& context);

/// Writes the inputs and the cost of a result, the same for every kind of run.
void write_origins(formats::Tree& tree, const scenes::LoadedScene& loaded, const RunContext& context,
                   const Statistics& statistics);

/// Writes figures of a gear below /netloft/gear, under their names; a scene without a gear has none.
void write_gear(formats::Tree& tree, const scenes::LoadedScene& loaded,
                const std::vector<NamedScalar>& figures);

/// The name of a result with this outcome: `wanted`, or NAME.not-converged.hdf beside it if the result that
/// is there is better. A worse result never replaces a better one.
std::filesystem::path name_beside_better(const std::filesystem::path& wanted, const std::string& outcome);

/// Writes the complete result of a run into `file`, as described in io/formats/hdf5/LAYOUT.md, and finishes
/// it as `result.output_file`.
void write_result(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                  const RunResult& result, const RunContext& context);

}  // namespace netloft::results
