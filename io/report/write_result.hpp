// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/hdf5/result_file.hpp"
#include "io/report/run_result.hpp"

namespace netloft::io {

/// Facts of a run that stand in no result.
struct RunContext {
  std::vector<std::string> command;
  std::string started;
  std::vector<const PluginOrigin*> plugins;
  std::string plan_text;
};

/// Where a result comes from and what it cost: what every kind of run writes.
void write_origins(Tree& tree, const LoadedScene& loaded, const RunContext& context, const Books& books);

/// Figures of a gear under /netloft/gear, by their names; nothing of a scene without one.
void write_gear(Tree& tree, const LoadedScene& loaded, const std::vector<NamedScalar>& figures);

/// Writes all of a run into `file`, as io/hdf5/LAYOUT.md says, and finishes it.
void write_result(ResultFile& file, const LoadedScene& loaded, const Assembler& assembler,
                  const RunResult& result, const RunContext& context);

}  // namespace netloft::io
