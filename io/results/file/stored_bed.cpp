// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/stored_shape.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::results {

namespace {

/// The index of the interval of ascending `places` that contains x, and the position of x in the interval,
/// from 0 to 1. An x beyond the ends is moved to the nearest end.
std::pair<std::size_t, double> interval_of(const std::vector<double>& places, double x) {
  const auto after = std::upper_bound(places.begin() + 1, places.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - places.begin()) - 1;
  return {i, std::clamp((x - places[i]) / (places[i + 1] - places[i]), 0.0, 1.0)};
}

}  // namespace

double StoredBed::height(double x, double y) const {
  const double plane = slope_x * x + slope_y * y - depth;
  if (is_plane()) return plane;
  const auto [i, s] = interval_of(relief_x, x);
  const auto [j, t] = interval_of(relief_y, y);
  const double* here = &relief[i * relief_y.size() + j];
  const double* next = here + relief_y.size();
  return plane + std::lerp(std::lerp(here[0], here[1], t), std::lerp(next[0], next[1], t), s);
}

}  // namespace netloft::results
