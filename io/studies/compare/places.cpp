// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::studies {

namespace {

using Point = std::array<double, 3>;

/// Converts a fraction to units of 1e-9. The offset keeps quotients of small integers away from the boundary
/// between two units, so that two fractions that differ only by round-off get the same number.
std::int64_t in_units(double fraction) {
  return static_cast<std::int64_t>(std::floor(fraction * 1e9 + 0.317));
}

/// Returns the position of the part's node `own` as fractions of the width and of the length.
std::array<double, 2> fractions_of(const scenes::PartGeometry& part, std::size_t own,
                                   std::array<double, 2> size) {
  if (!part.panel.empty()) return {part.panel[own][0] / size[0], part.panel[own][1] / size[1]};
  return {part.nodes.size() > 1 ? double(own) / double(part.nodes.size() - 1) : 0.0, 0.0};
}

/// Returns the extent of the part across and along it, in meshes.
std::array<double, 2> size_of(const scenes::PartGeometry& part) {
  std::array<double, 2> size{};
  for (const auto& at : part.panel)
    for (std::size_t k = 0; k < 2; ++k) size[k] = std::max(size[k], at[k]);
  return size;
}

double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

/// Calls visit(spot, position in a, position in b) for every spot that is in `a` and in `b`.
template <class Visit>
void for_common(const Places& a, const Places& b, const Visit& visit) {
  for (const auto& [spot, place] : a)
    if (const auto other = b.find(spot); other != b.end()) visit(spot, place, other->second);
}

}  // namespace

Places places_of(const scenes::LoadedScene& loaded, std::span<const double> positions) {
  Places places;
  for (std::uint32_t p = 0; p < loaded.parts.size(); ++p) {
    const scenes::PartGeometry& part = loaded.parts[p];
    const auto size = size_of(part);
    for (std::size_t own = 0; own < part.nodes.size(); ++own) {
      const auto [s, t] = fractions_of(part, own, size);
      const std::size_t at = 3 * std::size_t{part.nodes[own]};
      places[{p, {in_units(s), in_units(t)}}] = {positions[at], positions[at + 1], positions[at + 2]};
    }
  }
  return places;
}

double largest_distance(const Places& a, const Places& b) {
  double largest = -1;
  for_common(a, b, [&](const Spot&, const Point& here, const Point& there) {
    largest = std::max(largest, distance(here, there));
  });
  return largest < 0 ? std::numeric_limits<double>::quiet_NaN() : largest;
}

double mean_distance(const Places& a, const Places& b, const Places& among) {
  double sum = 0;
  std::size_t count = 0;
  for_common(a, b, [&](const Spot& spot, const Point& here, const Point& there) {
    if (!among.contains(spot)) return;
    const double d = distance(here, there);
    sum += d * d;
    ++count;
  });
  return std::sqrt(sum / static_cast<double>(count));
}

Places extrapolate(const Places& a, const Places& b, double w, const Places& among) {
  Places limit;
  for_common(a, b, [&](const Spot& spot, const Point& here, const Point& there) {
    if (!among.contains(spot)) return;
    for (std::size_t k = 0; k < 3; ++k) limit[spot][k] = here[k] + w * (here[k] - there[k]);
  });
  return limit;
}

}  // namespace netloft::studies
