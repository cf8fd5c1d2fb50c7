// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <limits>

#include "solvers/methods/newton/line_search.hpp"
#include "solvers/methods/newton/newton.hpp"

namespace netloft::newton {

/// The range of the damping μ of K + μ M (newton.hpp (2)), and how μ rises and falls. Below `least_damping`,
/// μ becomes 0. If K is unsymmetric, its factorisation does not show whether K is positive definite. In that
/// case, μ rises from 0 to √ε at once, but may fall to ε (the rounding error of a double), because soft parts
/// of a gear need less damping than stiff parts.
struct DampingRange {
  double least, most, factor;
  double end;  // a μ below this becomes 0

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
