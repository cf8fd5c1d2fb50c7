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

/// The path of the result of a run. Throws UsageError if this path is one of the scene's input files.
std::string output_file(const RunOptions& options, const scenes::LoadedScene& loaded);

/// Throws UsageError if `part` has outputs of an unfinished motion, unless the options resume or replace it.
void protect_outputs(const RunOptions& options, const std::string& part);

/// Returns the final path of a result: the path of `file` or, if a better result is already there, another
/// path beside it. In the second case, reports both paths on the terminal.
std::string name_by_outcome(const formats::ResultFile& file, const Solution& solution, Terminal& terminal);

/// Prints the same text as `netloft report` for this result.
void print_result(const RunOptions& options, Terminal& terminal, const results::Result& result);

/// A result file that is removed if the run ends without a result.
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
