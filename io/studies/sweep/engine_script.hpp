// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study.hpp"

namespace netloft::studies {

/// Who starts the programs that compute items.
enum class Engine { parallel, slurm };

/// Options of a script for an engine.
struct ScriptOptions {
  std::string program;               // path of netloft
  std::vector<std::string> plugins;  // folders, as --plugins takes them
  std::size_t chunk = 1;             // items that one program computes
  std::string why_chunk;             // a sentence about that
  int jobs = 0;                      // programs at a time; 0: as many as there are cores
};

/// The name of the script in the folder of the study.
std::string script_name(Engine engine);

/// A script for bash that lets an engine compute all items that have no record, and collects the table. It
/// says in its head what it does and how it is started. Started again it goes on.
std::string engine_script(Engine engine, const Study& study, const ScriptOptions& options);

/// Items for a task of at least a minute, by what items of the study have cost so far; 1 where none has been
/// computed.
std::size_t items_per_minute(const Study& study, const std::filesystem::path& folder,
                             double& seconds_per_item);

}  // namespace netloft::studies
