// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::studies {

double quantile_of(std::vector<double> sample, double p) {
  std::erase_if(sample, [](double x) { return !std::isfinite(x); });
  if (sample.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(sample.begin(), sample.end());
  const double h = static_cast<double>(sample.size() - 1) * std::clamp(p, 0.0, 1.0);
  const auto below = static_cast<std::size_t>(h);
  const double next = sample[std::min(below + 1, sample.size() - 1)];
  return sample[below] + (h - static_cast<double>(below)) * (next - sample[below]);
}

double mean_of(const std::vector<double>& sample) {
  double sum = 0;
  for (const double x : sample) sum += x;
  return sum / static_cast<double>(sample.size());
}

double deviation_of(const std::vector<double>& sample) {
  if (sample.size() < 2) return 0;
  const double mean = mean_of(sample);
  double sum = 0;
  for (const double x : sample) sum += (x - mean) * (x - mean);
  return std::sqrt(sum / static_cast<double>(sample.size() - 1));
}

}  // namespace netloft::studies
