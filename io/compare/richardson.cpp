// SPDX-License-Identifier: BSD-3-Clause
#include "io/compare/richardson.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastOrder = 0.3, kMostOrder = 4.5, kSteady = 0.5, kHighestOrder = 20;

/// Right side of (2); increases with p.
double ratio_of(double p, double h3, double h2, double h1) {
  return (std::pow(h3 / h1, p) - std::pow(h2 / h1, p)) / (std::pow(h2 / h1, p) - 1);
}

double largest_difference(const std::vector<double>& values, std::size_t asked) {
  double largest = 0;
  for (const double v : values) largest = std::max(largest, std::abs(v - values[asked]));
  return largest;
}

/// Sets the limit and the error from the two finest levels, by (3).
void extrapolate(Trend& trend, double order, const std::vector<double>& values, const std::vector<double>& h,
                 std::size_t asked) {
  const std::size_t fine = values.size() - 1, coarse = fine - 1;
  const double w = extrapolation_weight(order, h[coarse], h[fine]);
  trend.limit = values[fine] + w * (values[fine] - values[coarse]);
  trend.error = std::abs(values[asked] - trend.limit);
}

}  // namespace

double observed_order(double coarse_difference, double fine_difference, double h3, double h2, double h1) {
  const double wanted = coarse_difference / fine_difference;
  double low = 1e-6, high = kHighestOrder;
  if (!(coarse_difference > 0 && fine_difference > 0) || !std::isfinite(wanted)) return kNone;
  if (wanted <= ratio_of(low, h3, h2, h1) || wanted >= ratio_of(high, h3, h2, h1)) return kNone;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (ratio_of(middle, h3, h2, h1) < wanted ? low : high) = middle;
  }
  return low;
}

double extrapolation_weight(double order, double h2, double h1) {
  return 1 / (std::pow(h2 / h1, order) - 1);  // (3)
}

bool is_credible(double order) { return order >= kLeastOrder && order <= kMostOrder; }

bool is_steady(std::span<const double> orders) {
  if (orders.empty() || !std::all_of(orders.begin(), orders.end(), is_credible)) return false;
  const auto [least, most] = std::minmax_element(orders.begin(), orders.end());
  return *most - *least <= kSteady;
}

Trend find_trend(const std::vector<double>& values, const std::vector<double>& h, std::size_t asked) {
  Trend trend;
  const std::size_t n = values.size();
  if (n < 2) return trend;
  if (n == 2) {
    extrapolate(trend, 1, values, h, asked);
    return trend;
  }
  const double coarse = values[n - 2] - values[n - 3], fine = values[n - 1] - values[n - 2];
  if (coarse * fine > 0)
    trend.order = observed_order(std::abs(coarse), std::abs(fine), h[n - 3], h[n - 2], h[n - 1]);
  trend.steady = is_credible(trend.order);
  if (trend.steady)
    extrapolate(trend, trend.order, values, h, asked);
  else
    trend.error = largest_difference(values, asked);
  return trend;
}

}  // namespace netloft::io
