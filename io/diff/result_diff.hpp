// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/diff/line_changes.hpp"
#include "io/diff/result_summary.hpp"

#include <set>

namespace netloft::io {

/// One number in two results. What only one of them has is unknown in the other.
struct NumberDifference {
  std::string name, unit;
  double before = ResultNumber::kUnknown, after = ResultNumber::kUnknown;
  double error = ResultNumber::kUnknown;  // sum of all errors known of either; unknown: none is

  double difference() const { return after - before; }
  /// Of what it was before; not known of zero.
  double percent() const;
  /// By more than round-off.
  bool is_changed() const;
  /// Larger than the errors known of it.
  bool exceeds() const;
};

/// A file of the scene that is not the same in both, with its lines; or one that only one has.
struct FileDifference {
  std::string before, after;  // paths; empty: not there
  std::vector<LineChange> lines;
};

/// What is not the same of the inputs of two results.
struct InputDifferences {
  std::set<std::string> options_before, options_after;  // "--set water.current=[1,0,0]" of one only
  std::vector<FileDifference> files;
  std::vector<std::string> plugins;  // of another build, or in one only
  bool other_program = false;

  bool none() const;
};

struct ResultDiff {
  ResultSummary before, after;
  std::vector<NumberDifference> numbers;  // by name, unchanged ones included
  InputDifferences inputs;

  bool both_are_answers() const { return before.is_answer() && after.is_answer(); }
};

/// Forces by part are compared where neither result has figures of a gear, which say the same.
ResultDiff compare_results(ResultSummary before, ResultSummary after);

}  // namespace netloft::io
