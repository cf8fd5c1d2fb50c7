// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/finite_values.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

std::int32_t find_column_not_finite(const SparsePattern& pattern, std::span<const double> values) {
  const auto is_bad = [](double v) { return !std::isfinite(v); };
  if (std::none_of(values.begin(), values.end(), is_bad)) return -1;
  for (std::size_t column = 0; column + 1 < pattern.column_start.size(); ++column)
    for (auto e = static_cast<std::size_t>(pattern.column_start[column]);
         e < static_cast<std::size_t>(pattern.column_start[column + 1]); ++e)
      if (is_bad(values[pattern.slot_of(e)])) return static_cast<std::int32_t>(column);
  return -1;  // only unused slots are not finite
}

}  // namespace netloft
