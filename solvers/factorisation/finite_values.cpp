// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/finite_values.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

std::int32_t find_column_not_finite(const SparsePattern& pattern, std::span<const double> values) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (bad == values.end()) return -1;
  const auto& start = pattern.column_start;
  const auto next_column = std::upper_bound(start.begin(), start.end(), bad - values.begin());
  return static_cast<std::int32_t>(next_column - start.begin()) - 1;
}

}  // namespace netloft
