// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/distribution.hpp"

#include "io/studies/variables/read_variable.hpp"

#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::studies {

namespace {

/// The standard normal distribution function F in (3) of distribution.hpp.
double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace

// For q above one half, F⁻¹(q) = −F⁻¹(1 − q) is more accurate, because 1 − q is exact.
double normal_quantile(double q) {
  return q <= 0.5 ? -std::numbers::sqrt2 * boost::math::erfc_inv(2 * q)
                  : std::numbers::sqrt2 * boost::math::erfc_inv(2 * (1 - q));
}

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

Distribution read_distribution(const Variable& variable, formats::TableReader& table,
                               const std::vector<std::string>& kinds) {
  static const std::vector<std::string> kNames = {"uniform", "logarithmic", "normal"};
  Distribution read;
  const std::string kind = table.choice(
      "distribution", {.allowed = kinds, .doc = "how samples lie in the range", .fallback = kinds.front()});
  read.kind = static_cast<Distribution::Kind>(std::find(kNames.begin(), kNames.end(), kind) - kNames.begin());
  if (read.kind == Distribution::Kind::logarithmic && !(variable.interval->low > 0))
    table.error("range", "must be above zero for a logarithmic distribution");
  if (read.kind != Distribution::Kind::normal) return read;
  read.mean = read_number_of(variable, table, "mean", "the middle of the normal distribution")
                  .value_or(variable.interval->low);
  read.deviation =
      read_number_of(variable, table, "deviation", "standard deviation of the normal distribution")
          .value_or(1);
  if (!variable.interval->contains(read.mean))
    table.error("mean", "lies outside the range, at which the distribution is cut off");
  if (!(read.deviation > 0)) table.error("deviation", "must be above zero");
  return read;
}

}  // namespace netloft::studies
