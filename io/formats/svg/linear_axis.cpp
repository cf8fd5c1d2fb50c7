// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/linear_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::formats {

namespace {

constexpr double kRangeMargin = 0.04;  // distance of markers from the frame, as a fraction of the range
// Values with a smaller relative difference count as equal, because labels do not have room for more digits.
constexpr double kSame = 1e-6;
constexpr double kTickRounding = 1e-9;  // tolerance for rounding, as a fraction of the distance of ticks

/// The smallest of 1, 2 and 5 times a power of ten that is not less than `length`.
double round_length(double length) {
  const double decade = std::pow(10.0, std::floor(std::log10(length) + kTickRounding));
  for (const double step : {1.0, 2.0, 5.0})
    if (length <= step * decade * (1 + kTickRounding)) return step * decade;
  return 10 * decade;
}

}  // namespace

LinearAxis::LinearAxis(std::span<const double> values, int most_labels) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double v : values)
    if (std::isfinite(v)) {
      least = std::min(least, v);
      most = std::max(most, v);
    }
  if (least > most) {
    least = 0;
    most = 1;
  }
  const double size = std::max({std::abs(least), std::abs(most), std::numeric_limits<double>::min()});
  if (most - least < kSame * size) {
    const double half = std::max(kSame * size, least == 0 && most == 0 ? 0.5 : 0.05 * size);
    least -= half;
    most += half;
  }
  const double margin = kRangeMargin * (most - least);
  low_ = least - margin;
  high_ = most + margin;
  find_ticks(most_labels);
}

bool LinearAxis::has_place(double value) const { return std::isfinite(value); }

double LinearAxis::place(double value) const { return (value - low_) / (high_ - low_); }

void LinearAxis::find_ticks(int most_labels) {
  const double step = round_length((high_ - low_) / std::max(1, most_labels));
  for (double n = std::ceil(low_ / step - kTickRounding); n * step <= high_ + kTickRounding * step; ++n)
    ticks_.push_back({n * step, true});
}

}  // namespace netloft::formats
