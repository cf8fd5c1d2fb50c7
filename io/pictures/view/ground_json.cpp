// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/ground_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::pictures {

namespace {

struct Stretch {
  double first = INFINITY, last = -INFINITY;

  void take(double x) {
    if (std::isfinite(x)) {
      first = std::min(first, x);
      last = std::max(last, x);
    }
  }
  double size() const { return last - first; }
};

/// The region around all nodes of the last state, extended on every side by its own size.
std::array<Stretch, 2> region_of(const results::StoredShape& stored) {
  std::array<Stretch, 2> region;
  const auto points = stored.points(stored.times.size() - 1);
  for (std::size_t n = 0; n + 2 < points.size(); n += 3) {
    region[0].take(points[n]);
    region[1].take(points[n + 1]);
    if (stored.result.is_half()) region[1].take(-points[n + 1]);
  }
  const double margin = std::max({region[0].size(), region[1].size(), 1.0});
  for (auto& range : region) {
    if (!(range.size() >= 0)) range = {0, 0};
    range.first -= margin;
    range.last += margin;
  }
  return region;
}

}  // namespace

nlohmann::ordered_json ground_json(const results::StoredShape& stored) {
  const auto [x, y] = region_of(stored);
  const int places = stored.bed && !stored.bed->is_plane() ? 65 : 2;
  const auto at = [&](const Stretch& range, int k) {
    return std::lerp(range.first, range.last, static_cast<double>(k) / (places - 1));
  };
  nlohmann::ordered_json heights;
  for (int i = 0; stored.bed && i < places; ++i)
    for (int j = 0; j < places; ++j)
      heights.push_back(std::round(1e6 * stored.bed->height(at(x, i), at(y, j))) / 1e6);
  return {{"x", {x.first, x.last}}, {"y", {y.first, y.last}}, {"places", places}, {"heights", heights}};
}

}  // namespace netloft::pictures
