// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/march_times.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

MarchTimes::MarchTimes(const MarchSettings& settings, std::vector<double> corners)
    : settings_(settings), corners_(std::move(corners)) {
  if (!settings.dense)
    for (std::size_t i = 0; i < output_count(); ++i) corners_.push_back(output(i));
  corners_.push_back(settings.duration);
  std::sort(corners_.begin(), corners_.end());
}

std::size_t MarchTimes::output_count() const {
  if (settings_.output_interval <= 0) return 2;
  return static_cast<std::size_t>(std::ceil(settings_.duration / settings_.output_interval - 1e-9)) + 1;
}

double MarchTimes::output(std::size_t i) const {
  return i + 1 >= output_count() ? settings_.duration : static_cast<double>(i) * settings_.output_interval;
}

bool MarchTimes::is_output(double t) const {
  if (settings_.dense || settings_.output_interval <= 0 || t >= settings_.duration) return true;
  const double outputs = t / settings_.output_interval;
  return std::abs(outputs - std::round(outputs)) < 1e-9;
}

double MarchTimes::next_corner(double t) const {
  const double least = t + 1e-12 * std::max(1.0, settings_.duration);
  const auto next = std::upper_bound(corners_.begin(), corners_.end(), least);
  return next == corners_.end() ? settings_.duration : std::min(*next, settings_.duration);
}

}  // namespace netloft
