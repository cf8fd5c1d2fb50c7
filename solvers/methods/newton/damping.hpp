// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <limits>

#include "solvers/methods/newton/line_search.hpp"
#include "solvers/methods/newton/newton.hpp"

namespace netloft::newton {

/// Between which ends μ of (2) lies, and how it rises and falls. Whether an unsymmetric K curves downwards is
/// not known: its damping begins with as much as half of its digits, and ends at their rounding, since soft
/// parts of a gear want less than stiff ones, by the ratio of their stiffnesses.
struct DampingRange {
  double least, most, factor;
  double end;  // what would fall below it is none at all

  DampingRange(const Newton::Parameters& p, bool is_symmetric)
      : least(is_symmetric ? p.least_damping : kShortest),
        most(p.most_damping),
        factor(p.factor),
        end(is_symmetric ? p.least_damping : std::numeric_limits<double>::epsilon()) {}

  double raised(double damping, double by) const { return std::clamp(damping * by, least, most); }
  double raised(double damping) const { return raised(damping, factor); }
  double lowered(double damping) const { return damping < factor * end ? 0 : damping / factor; }
};

}  // namespace netloft::newton
