// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/handle.hpp"
#include "io/program/commands/results.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/print.hpp"
#include "io/results/diff/report_diff.hpp"
#include "io/results/file/read_result.hpp"

namespace netloft::program {

namespace {

results::Result read(const std::string& path, bool json) {
  return on_file(path, json, [&] { return results::read_result(path); });
}

/// The largest displacement of a node between both results; nullopt unless both files have a shape that this
/// program can read.
std::optional<results::NodeMove> move_between(const DiffOptions& options) {
  const DamagedFileWatch watch(options.before + " or " + options.after, options.json);
  try {
    return results::find_largest_move(results::StoredShape(options.before),
                                      results::StoredShape(options.after));
  } catch (const formats::FileError&) {
    return {};
  }
}

}  // namespace

int diff_command(const DiffOptions& options) {
  results::ResultDiff diff =
      results::compare_results(read(options.before, options.json), read(options.after, options.json));
  diff.move = move_between(options);
  print_line(options.json ? results::diff_json(diff) : results::diff_text(diff, options.all));
  return diff.both_are_answers() ? kDone : kNotConverged;
}

}  // namespace netloft::program
