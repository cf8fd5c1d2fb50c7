// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/commands.hpp"
#include "io/program/session/last_words.hpp"
#include "io/results/diff/report_diff.hpp"
#include "io/formats/hdf5/handle.hpp"

#include <cstdio>

namespace netloft::io {

namespace {

ResultSummary read(const std::string& path, bool json) {
  return on_file(path, json, [&] { return read_summary(path); });
}

/// How far nodes moved, where both files hold a shape that this program reads.
std::optional<NodeMove> move_between(const Options& options) {
  const DamagedFileWatch watch(options.target + " or " + options.other, options.json);
  try {
    return find_largest_move(StoredResult(options.target), StoredResult(options.other));
  } catch (const FileError&) {
    return {};
  }
}

}  // namespace

int diff_command(const Options& options) {
  ResultDiff diff = compare_results(read(options.target, options.json), read(options.other, options.json));
  diff.move = move_between(options);
  std::puts(options.json ? diff_json(diff).c_str() : diff_text(diff).c_str());
  return diff.both_are_answers() ? kDone : kNotConverged;
}

}  // namespace netloft::io
