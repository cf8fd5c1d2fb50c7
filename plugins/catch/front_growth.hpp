// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/in_time.hpp"

#include <stdexcept>

namespace netloft::catches {

/// Throws std::invalid_argument if a growth (the fraction of the volume over time) is given without a volume,
/// or is not positive at all times.
inline void check_growth(const netloft_table& growth, double volume) {
  if (growth.rows == 0) return;
  if (volume == 0) throw std::invalid_argument("catch.growth needs catch.volume, the volume that grows");
  if (!in_time::is_positive(growth))
    throw std::invalid_argument("the catch must have a volume at all times: its growth must be positive");
}

}  // namespace netloft::catches
