// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/run_output.hpp"

#include "framework/motion/march_ending.hpp"
#include "io/formats/hdf5/fold.hpp"
#include "io/formats/hdf5/journal.hpp"
#include "io/formats/hdf5/open.hpp"
#include "io/formats/hdf5/read.hpp"
#include "io/program/session/print.hpp"
#include "io/results/file/write_result.hpp"
#include "io/results/text/result_text.hpp"

#include <filesystem>

namespace netloft::program {

namespace {

/// Whether a .part is an HDF5 file without a checkpoint. Such a file comes from a search for an equilibrium
/// and can be replaced, because it has no results before the equilibrium is found. The .part of a motion by
/// an earlier version is also an HDF5 file, but has a checkpoint.
bool is_worthless_hdf5(const std::string& part) {
  if (!formats::is_hdf5_file(part)) return false;
  try {
    return !formats::Reader(part).has("/netloft/checkpoint");
  } catch (const formats::FileError&) {
    return true;
  }
}

/// Describes how the run that wrote a journal ended, as the end of a sentence.
std::string how_it_ended(const std::string& outcome) {
  if (outcome == formats::kRunning.outcome || outcome == name_of(MarchStatus::interrupted))
    return "did not end; --resume goes on from them";
  return "has ended (" + outcome +
         "), but could not write its result or the .xdmf file beside it; --resume writes them";
}

}  // namespace

std::string output_file(const RunOptions& options, const scenes::LoadedScene& loaded) {
  const std::string name = options.output.empty() ? loaded.scene.name + ".hdf" : options.output;
  std::error_code missing;
  for (const auto& file : loaded.files)
    if (std::filesystem::equivalent(name, file.path, missing))
      throw UsageError{"the result cannot be written to " + name +
                       ": the scene is read from it; name another file with -o"};
  return name;
}

void protect_outputs(const RunOptions& options, const std::string& part) {
  std::error_code none;
  if (options.resume || options.overwrite || !std::filesystem::is_regular_file(part, none) ||
      std::filesystem::file_size(part, none) == 0)
    return;
  formats::require_no_writer(part);
  const std::string cure = "; --overwrite replaces it, -o writes elsewhere";
  try {
    if (is_worthless_hdf5(part)) return;
    if (const auto left = formats::SeriesJournal::read(part); left.size() > 0)
      throw UsageError{part + " holds " + std::to_string(left.size()) + " outputs of a run that " +
                       how_it_ended(left.status().outcome) + cure};
  } catch (const formats::FileError& e) {
    throw UsageError{std::string(e.what()) + ". A run that did not end left this file" + cure};
  }
}

std::string name_by_outcome(const formats::ResultFile& file, const Solution& solution, Terminal& terminal) {
  const auto wanted = file.final_path();
  const auto name = results::name_beside_better(wanted, name_of(solution.status));
  if (name != wanted)
    terminal.say("netloft: " + wanted.string() + " holds a better result and is kept; the new result is " +
                 name_of(solution.status) + " and is written to " + name.string());
  return name.string();
}

void print_result(const RunOptions& options, Terminal& terminal, const results::Result& result) {
  terminal.clear();
  print(options.json ? results::result_json(result) + "\n" : results::result_text(result));
}

}  // namespace netloft::program
