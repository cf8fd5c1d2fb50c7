// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/variables/variable.hpp"

namespace netloft::io {

/// How the draws of a variable lie in its interval. With p in (0, 1) for equally likely draws and F the
/// standard normal distribution,
///   uniform       low + p (high − low)                                                     (1)
///   logarithmic   low (high/low)^p, low > 0                                                (2)
///   normal        mean + deviation F⁻¹(q), q from F at the low end to F at the high end    (3)
/// (3) is the normal distribution cut off at both ends.
struct Distribution {
  enum class Kind { uniform, logarithmic, normal };
  Kind kind = Kind::uniform;
  double mean = 0, deviation = 1;  // of (3), in the variable's unit
};

/// The number below which a fraction p of all draws lies.
double quantile(const Distribution& distribution, const Interval& interval, double p);

}  // namespace netloft::io
