// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/diff/line_changes.hpp"
#include "io/results/diff/node_moves.hpp"
#include "io/results/figures/result.hpp"

#include <limits>
#include <set>

namespace netloft::results {

/// A number of the results `before` and `after`. If a result does not have the number, its value there is
/// NaN.
struct NumberDifference {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::string name, unit;
  double before = kUnknown, after = kUnknown;
  // Sum of the solver and mesh errors of both values. NaN if one of them is unknown, because the mesh error
  // is usually by far the largest.
  double error = kUnknown;
  double floor = 0;  // differences below this are round-off

  double difference() const { return after - before; }
  /// The difference relative to the value before; NaN if that value is zero.
  double percent() const;
  /// Whether the difference exceeds round-off.
  bool is_changed() const;
  /// Whether the difference exceeds `error`; false if that is not known.
  bool exceeds() const;
};

/// A file of the scene whose lines differ between the results, or a file that only one result has.
struct FileDifference {
  std::string before, after;  // paths; empty: this result has no such file
  std::vector<LineChange> lines;
};

/// The differences between the inputs of two results.
struct InputDifferences {
  // Options that only one command line has, such as "--set water.current=[1,0,0]".
  std::set<std::string> options_before, options_after;
  std::vector<FileDifference> files;
  std::vector<std::string> plugins;  // plugins built differently, or present in one result only
  bool other_program = false;

  bool none() const;
};

struct ResultDiff {
  Result before, after;
  std::vector<NumberDifference> numbers;  // sorted by name; unchanged ones are included
  InputDifferences inputs;
  std::optional<NodeMove> move;  // nullopt: not compared

  bool both_are_answers() const { return before.is_answer() && after.is_answer(); }
};

/// Compares numbers, inputs and node positions. Forces by part are compared only if neither result has
/// figures of a gear, which contain these forces.
ResultDiff compare_results(Result before, Result after);

}  // namespace netloft::results
