// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/diff/key_changes.hpp"
#include "io/results/diff/node_moves.hpp"
#include "io/results/figures/result.hpp"

#include <limits>
#include <set>

namespace netloft::results {

/// A number that the results `before` and `after` have. If one of them lacks it, its value there is NaN.
struct NumberDifference {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::string name, unit;
  double before = kUnknown, after = kUnknown;
  // For each value, the sum of solver error and mesh error. NaN unless both are known, because the mesh error
  // is usually by far the larger one.
  double error_before = kUnknown, error_after = kUnknown;
  double floor = 0;  // differences below this are round-off

  double difference() const { return after - before; }
  double error() const { return error_before + error_after; }
  /// The difference relative to the value before; NaN if that value is zero.
  double percent() const;
  /// The difference relative to the larger of the two values; 1 if only one result has the number.
  double share() const;
  /// Whether both values are known exactly, without a solver or a mesh.
  bool is_exact() const;
  /// Whether the difference exceeds round-off.
  bool is_changed() const;
  /// Whether the difference exceeds error(); false if error() is not known.
  bool exceeds() const;
};

/// A file that only one result has, or whose text differs between the results. The files of the scenes are
/// not compared one by one, but as merged scenes.
struct FileDifference {
  std::string before, after;    // paths; empty: this result has no such file
  std::vector<KeyChange> keys;  // the keys that differ, if both are TOML
};

/// The differences between the inputs of two results.
struct InputDifferences {
  std::vector<KeyChange> keys;   // keys of the scenes that differ
  bool are_scenes_known = true;  // false: a result lacks the texts of its scene, so that `keys` is empty
  // Options that only one command line has, such as "--solver newton"; --set is part of the scene.
  std::set<std::string> options_before, options_after;
  std::vector<FileDifference> files;
  std::vector<std::string> plugins;  // plugins built differently, or present in one result only
  bool other_program = false;
  bool other_text = false;  // comments, spaces or the division into files differ

  /// Whether nothing differs, except perhaps `other_text`.
  bool none() const;
};

struct ResultDiff {
  Result before, after;
  std::vector<NumberDifference> numbers;  // sorted by name; unchanged ones are included
  // Indices of the changed numbers that a report shows first. The order is: changes that exceed their errors,
  // key figures (key_figures.hpp), other figures; within each group, the largest share() comes first. Figures
  // without any error, such as a weight, come last, because they depend on the input only.
  std::vector<std::size_t> figures;
  InputDifferences inputs;
  std::optional<NodeMove> move;  // nullopt: not compared

  bool both_are_answers() const { return before.is_answer() && after.is_answer(); }
};

/// Compares numbers, inputs and node positions. Forces on parts are compared only if neither result has
/// figures of a gear, which already contain these forces.
ResultDiff compare_results(Result before, Result after);

}  // namespace netloft::results
