// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/commands.hpp"
#include "io/diff/report_diff.hpp"
#include "io/hdf5/handle.hpp"

#include <cstdio>

namespace netloft::io {

namespace {

ResultSummary read(const std::string& path) {
  try {
    return read_summary(path);
  } catch (const FileError& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace

int diff_command(const Options& options) {
  const ResultDiff diff = compare_results(read(options.target), read(options.other));
  std::puts(options.json ? diff_json(diff).c_str() : diff_text(diff).c_str());
  return diff.both_are_answers() ? kDone : kNotConverged;
}

}  // namespace netloft::io
