// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/log_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::formats {

namespace {

// Relative difference up to which an end of the axis counts as equal to a value. Computed powers of ten have
// rounding errors.
constexpr double kDecadeRounding = 1e-9;
// Markers keep at least this factor away from the frame.
constexpr double kMarginFactor = 1.15;
// With more decades than this, their inner ticks would overlap.
constexpr int kMostSubdivided = 5;

double power_of_ten(int exponent) { return std::pow(10.0, exponent); }
int decade_below(double value) { return static_cast<int>(std::floor(std::log10(value) + kDecadeRounding)); }

/// The largest number n 10^k with n from 1 to 9 that is not greater than `value`; round_up() returns the
/// smallest such number that is not less than `value`.
double round_down(double value) {
  const double decade = power_of_ten(decade_below(value));
  return std::floor(value / decade + kDecadeRounding) * decade;
}
double round_up(double value) {
  const double decade = power_of_ten(decade_below(value));
  return std::ceil(value / decade - kDecadeRounding) * decade;
}

/// The number of decades between two labels, chosen such that at most `most` of `count` powers of ten have
/// labels.
int label_stride(int count, int most) { return std::max(1, (count + most - 1) / std::max(1, most)); }

}  // namespace

LogAxis::LogAxis(std::span<const double> values, int most_labels) {
  low_ = 1;
  high_ = 10;
  labels_powers_ = true;
  find_ends(values);
  find_ticks(most_labels);
}

bool LogAxis::has_place(double value) const { return value > 0 && std::isfinite(value); }

double LogAxis::place(double value) const { return std::log(value / low_) / std::log(high_ / low_); }

void LogAxis::find_ends(std::span<const double> values) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double v : values)
    if (v > 0 && std::isfinite(v)) {
      least = std::min(least, v);
      most = std::max(most, v);
    }
  if (most == 0) return;
  low_ = round_down(least / kMarginFactor);
  high_ = round_up(most * kMarginFactor);
  if (high_ < 4 * low_) {
    low_ = round_down(low_ / 2);
    high_ = round_up(high_ * 2);
  }
}

void LogAxis::find_ticks(int most_labels) {
  const int first = decade_below(low_), last = decade_below(high_);
  const int whole = decade_below(high_) - static_cast<int>(std::ceil(std::log10(low_) - kDecadeRounding)) + 1;
  const int stride = label_stride(whole, most_labels);
  labels_powers_ = whole >= 2;
  const bool subdivided = last - first <= kMostSubdivided;
  for (int exponent = first; exponent <= last; ++exponent)
    for (int step = 1; step <= (subdivided ? 9 : 1); ++step) {
      const double value = step * power_of_ten(exponent);
      if (value < low_ * (1 - kDecadeRounding) || value > high_ * (1 + kDecadeRounding)) continue;
      const bool labelled = step == 1 ? exponent % stride == 0 : !labels_powers_ && (step == 2 || step == 5);
      ticks_.push_back({value, labelled});
    }
}

}  // namespace netloft::formats
