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

/// The shape at the end of one stage of the search for the equilibrium.
struct StageShape {
  std::string name;       // such as "coarse: converged"
  std::vector<double> x;  // values of all degrees of freedom
};

/// The shapes of a solve, which a Result does not contain.
struct SolvedShapes {
  const Solution& end;
  std::vector<StageShape> stages = {};  // shapes before the last; empty: they were not stored
};

/// Writes the facts that are known when a run begins.
void write_inputs(formats::Tree& tree, const scenes::LoadedScene& loaded, const Result& result);

/// Writes the facts that are known when a run (static or a motion) has ended, except shapes and forces.
void write_ending(formats::Tree& tree, const Result& result);

/// The path under which a result with this outcome is written, so that a worse result never replaces a better
/// one: `wanted`, or, if `wanted` exists and has a better outcome, NAME.not-converged.hdf beside it.
std::filesystem::path name_beside_better(const std::filesystem::path& wanted, const std::string& outcome);

/// Writes a static result with its shapes into `file` (layout: io/formats/hdf5/LAYOUT.md). After that, the
/// file is complete, but it keeps its temporary name until ResultFile::finish().
void write_result(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                  const SolvedShapes& shapes, const Result& result);

}  // namespace netloft::results
