// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/handle.hpp"
#include "io/program/session/commands.hpp"
#include "io/program/session/last_words.hpp"
#include "io/results/diff/report_diff.hpp"

#include <cstdio>

namespace netloft::program {

namespace {

results::ResultSummary read(const std::string& path, bool json) {
  return on_file(path, json, [&] { return results::read_summary(path); });
}

/// How far nodes moved, where both files hold a shape that this program reads.
std::optional<results::NodeMove> move_between(const Options& options) {
  const DamagedFileWatch watch(options.target + " or " + options.other, options.json);
  try {
    return results::find_largest_move(results::StoredResult(options.target),
                                      results::StoredResult(options.other));
  } catch (const formats::FileError&) {
    return {};
  }
}

}  // namespace

int diff_command(const Options& options) {
  results::ResultDiff diff =
      results::compare_results(read(options.target, options.json), read(options.other, options.json));
  diff.move = move_between(options);
  std::puts(options.json ? results::diff_json(diff).c_str() : results::diff_text(diff).c_str());
  return diff.both_are_answers() ? kDone : kNotConverged;
}

}  // namespace netloft::program
