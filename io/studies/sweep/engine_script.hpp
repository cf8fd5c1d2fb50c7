// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study.hpp"

namespace netloft::studies {

/// The program that runs the items of a study, some per task: GNU parallel or Slurm.
enum class Engine { parallel, slurm };

/// Options of a script for an engine.
struct ScriptOptions {
  std::string program;               // path of netloft
  std::vector<std::string> plugins;  // folders of plugins, in the syntax of --plugins
  std::size_t chunk = 1;             // number of items in a task
  std::string why_chunk;             // the reason for `chunk`, a sentence
  int jobs = 0;                      // tasks at a time; 0: one per core
};

/// The name of the script in the folder of the study.
std::string script_name(Engine engine);

/// A bash script with which an engine computes all items of the study that have no record yet, and then
/// collects the table. The head of the script explains what it does and how to start it. A second start
/// resumes the work.
std::string engine_script(Engine engine, const Study& study, const ScriptOptions& options);

/// The number of items that together take at least a minute, estimated from the finished items of the study;
/// 1 if there are none. Sets `seconds_per_item` to the mean wall time of the finished items, 0 if it is not
/// known.
std::size_t items_per_minute(const Study& study, const std::filesystem::path& folder,
                             double& seconds_per_item);

}  // namespace netloft::studies
