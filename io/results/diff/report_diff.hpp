// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/diff/result_diff.hpp"

namespace netloft::results {

/// The differences as text: first the numbers that changed, marked with `*` if the change exceeds the known
/// errors, then the changes of the inputs.
std::string diff_text(const ResultDiff& diff);

/// One JSON object with all numbers; unknown values are null.
std::string diff_json(const ResultDiff& diff);

}  // namespace netloft::results
