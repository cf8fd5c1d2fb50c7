// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/diff/result_diff.hpp"

namespace netloft::io {

/// For people: numbers that changed, those that exceed the known errors marked with `*`; then the inputs.
std::string diff_text(const ResultDiff& diff);

/// One JSON object with all numbers; what is not known is null.
std::string diff_json(const ResultDiff& diff);

}  // namespace netloft::io
