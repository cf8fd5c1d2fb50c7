// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/diff/result_diff.hpp"

namespace netloft::results {

/// A text for people: the numbers that changed, marked with `*` if they exceed the known errors; then the
/// inputs.
std::string diff_text(const ResultDiff& diff);

/// One JSON object with all numbers; unknown values are null.
std::string diff_json(const ResultDiff& diff);

}  // namespace netloft::results
