// SPDX-License-Identifier: BSD-3-Clause
#include "io/result/field_range.hpp"

#include <algorithm>
#include <cstddef>

namespace netloft::io {

namespace {
constexpr std::size_t kSample = 20000;  // values of one state that the quantile is found from, at most
constexpr std::size_t kBelow = 50;      // one of so many lies below low()
}  // namespace

void FieldRange::take(const std::vector<double>& values) {
  const std::size_t step = 1 + values.size() / kSample;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    lo_ = std::min(lo_, values[i]), hi_ = std::max(hi_, values[i]);
    if (i % step == 0) sample_.push_back(values[i]);
  }
}

double FieldRange::low() const {
  if (sample_.empty()) return lo_;
  std::vector<double> sorted = sample_;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / kBelow);
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

}  // namespace netloft::io
