// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/richardson.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

constexpr double kNoOrder = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastOrder = 0.5, kMostOrder = 2.5, kSteady = 0.5, kHighestOrder = 20;
constexpr double kSafety = 1.25;        // safety factor in (4)
constexpr double kSafetyOfScatter = 2;  // safety factor in (5)
// Least change between meshes that counts as divergence, as a fraction of the value. Singular tensions, at
// rope ends on corners of netting, change by a tenth or more. Other figures that happen to drift change by
// less.
constexpr double kNoise = 0.1;

/// The right side of (2) in richardson.hpp, which increases with the order p.
double ratio_of(double p, double h3, double h2, double h1) {
  return (std::pow(h3 / h1, p) - std::pow(h2 / h1, p)) / (std::pow(h2 / h1, p) - 1);
}

/// The limit, (3) in richardson.hpp, from the value `coarse` on a mesh of width h2 and the value `fine` on a
/// mesh of width h1.
double limit_of(double order, double coarse, double fine, double h2, double h1) {
  return fine + extrapolation_weight(order, h2, h1) * (fine - coarse);
}

/// The error estimate, (5) in richardson.hpp, from the meshes from index `first` to the finest. trend.limit
/// is NaN if the observed order is not credible.
double bound(const Trend& trend, const std::vector<double>& values, const std::vector<double>& h,
             std::size_t asked, std::size_t first) {
  const std::size_t last = values.size() - 1;
  double largest = std::abs(values[asked] - limit_of(1, values[first], values[last], h[first], h[last]));
  if (std::isfinite(trend.limit)) largest = std::max(largest, std::abs(values[asked] - trend.limit));
  for (std::size_t k = first; k <= last; ++k)
    largest = std::max(largest, std::abs(values[k] - values[asked]));
  return kSafetyOfScatter * largest;
}

/// Sets order, limit and divergence from the three finest meshes.
void observe(Trend& trend, const std::vector<double>& values, const std::vector<double>& h) {
  const std::size_t n = values.size();
  const double coarse = values[n - 2] - values[n - 3], fine = values[n - 1] - values[n - 2];
  if (coarse * fine > 0)
    trend.order = observed_order(std::abs(coarse), std::abs(fine), h[n - 3], h[n - 2], h[n - 1]);
  trend.steady = is_credible(trend.order);
  if (trend.steady) trend.limit = limit_of(trend.order, values[n - 2], values[n - 1], h[n - 2], h[n - 1]);
  const double size = std::max(std::abs(values[n - 3]), std::abs(values[n - 1]));
  trend.diverges =
      coarse * fine > 0 && !(trend.order >= kLeastOrder) && std::abs(coarse + fine) > kNoise * size;
}

}  // namespace

double observed_order(double coarse_difference, double fine_difference, double h3, double h2, double h1) {
  const double wanted = coarse_difference / fine_difference;
  double low = 1e-6, high = kHighestOrder;
  if (!(coarse_difference > 0 && fine_difference > 0) || !std::isfinite(wanted)) return kNoOrder;
  if (wanted <= ratio_of(low, h3, h2, h1) || wanted >= ratio_of(high, h3, h2, h1)) return kNoOrder;
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

Trend find_trend(const std::vector<double>& values, const std::vector<double>& h, std::size_t asked,
                 bool similar) {
  Trend trend;
  const std::size_t n = values.size();
  if (n < 2) return trend;
  if (n == 2)
    trend.limit = limit_of(1, values[0], values[1], h[0], h[1]);
  else
    observe(trend, values, h);
  trend.error = similar && trend.steady ? kSafety * std::abs(values[asked] - trend.limit)
                                        : bound(trend, values, h, asked, n > 3 ? n - 3 : 0);
  return trend;
}

}  // namespace netloft::studies
