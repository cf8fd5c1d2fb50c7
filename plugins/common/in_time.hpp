// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

namespace netloft::in_time {

/// Returns the factor at a given time from a table with the columns t [s] and factor [1]. The factor is
/// linear between the rows, constant before the first and after the last, and 1 if there are no rows.
inline double factor_at(const netloft_table& table, double time) {
  if (table.rows == 0) return 1;
  const auto t = [&](std::uint32_t i) { return table.values[2 * i]; };
  const auto share = [&](std::uint32_t i) { return table.values[2 * i + 1]; };
  std::uint32_t after = 0;
  while (after < table.rows && t(after) < time) ++after;
  if (after == 0 || after == table.rows) return share(after ? after - 1 : 0);
  return share(after - 1) +
         (share(after) - share(after - 1)) * (time - t(after - 1)) / (t(after) - t(after - 1));
}

inline bool is_positive(const netloft_table& table) {
  for (std::uint32_t i = 0; i < table.rows; ++i)
    if (!(table.values[2 * i + 1] > 0)) return false;
  return true;
}

}  // namespace netloft::in_time
