// SPDX-License-Identifier: BSD-3-Clause
#include "io/sweep/distribution.hpp"

#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::io {

namespace {

/// F of (3).
double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// F⁻¹ of (3). From the upper half by symmetry, where 1 − q would lose its digits.
double normal_quantile(double q) {
  return q <= 0.5 ? -std::numbers::sqrt2 * boost::math::erfc_inv(2 * q)
                  : std::numbers::sqrt2 * boost::math::erfc_inv(2 * (1 - q));
}

}  // namespace

double quantile(const Distribution& d, const Interval& interval, double p) {
  const auto [low, high] = interval;
  double number = low + p * (high - low);                                                            // (1)
  if (d.kind == Distribution::Kind::logarithmic) number = low * std::exp(p * std::log(high / low));  // (2)
  if (d.kind == Distribution::Kind::normal) {
    const double from = normal_below((low - d.mean) / d.deviation),
                 to = normal_below((high - d.mean) / d.deviation);
    number = d.mean + d.deviation * normal_quantile(from + p * (to - from));  // (3)
  }
  return std::clamp(number, low, high);
}

}  // namespace netloft::io
