// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "io/formats/hdf5/result_file.hpp"
#include "io/program/commands/scenes.hpp"
#include "io/program/session/terminal.hpp"
#include "io/results/figures/result.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <string>

namespace netloft::program {

/// The result file of a run. Throws UsageError if it is one of the files that the scene was read from.
std::string output_file(const RunOptions& options, const scenes::LoadedScene& loaded);

/// Throws UsageError if `part` holds outputs of a motion that did not end, unless the options say that they
/// are to be continued or replaced.
void protect_outputs(const RunOptions& options, const std::string& part);

/// The name that a result gets: that of the file, or one beside it if the file holds a better result, which
/// the terminal reports.
std::string name_by_outcome(const formats::ResultFile& file, const Solution& solution, Terminal& terminal);

/// Prints what `netloft report` prints of the file of this result.
void print_result(const RunOptions& options, Terminal& terminal, const results::Result& result);

/// A result file that is removed if the run produces no result.
class OutputFile {
 public:
  explicit OutputFile(const std::string& name) : file_(name) {}
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() { file_.discard(); }
  formats::ResultFile& operator*() { return file_; }

 private:
  formats::ResultFile file_;
};

}  // namespace netloft::program
