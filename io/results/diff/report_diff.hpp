// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/diff/result_diff.hpp"

namespace netloft::results {

/// The changes of the inputs, one line each. Values are shortened to `most` letters.
std::vector<std::string> input_changes(const ResultDiff& diff, std::size_t most = std::string::npos);

/// A figure before and after, as reports print it.
struct FigureChange {
  std::string name;           // such as "headline height"
  std::string before, after;  // "1.98 ± 0.06 m"
  std::string difference, percent;
  bool exceeds = false;  // the change is larger than the errors of both results
};
FigureChange figure_change(const NumberDifference& difference);

/// A sentence about the errors of the figures that changed.
std::string errors_line(const ResultDiff& diff);

/// The differences as text: first the changed inputs, then the changed figures, the most important first.
/// Changes that exceed the known errors are marked with `*`. With `all`, every change is listed, and every
/// changed number is listed with its name in the file.
std::string diff_text(const ResultDiff& diff, bool all);

/// One JSON object with all numbers; unknown values are null.
std::string diff_json(const ResultDiff& diff);

}  // namespace netloft::results
