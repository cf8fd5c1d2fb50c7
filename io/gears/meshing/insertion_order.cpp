// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/insertion_order.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace netloft::gears {

namespace {

constexpr std::uint32_t kCells = 1u << 15;  // number along each axis; finer than the knots of any gear

/// The number of a cell along Hilbert's curve, which is computed quadrant by quadrant. In two of the four
/// quadrants, the curve is mirrored.
std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  for (std::uint32_t half = kCells / 2; half > 0; half /= 2) {
    const bool is_right = (x & half) != 0, is_upper = (y & half) != 0;
    place = 4 * place + (is_right ? (is_upper ? 2 : 3) : (is_upper ? 1 : 0));
    if (is_upper) continue;
    if (is_right) {
      x = kCells - 1 - x;
      y = kCells - 1 - y;
    }
    std::swap(x, y);
  }
  return place;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(const std::vector<PlanePoint>& points) {
  std::array<double, 2> low{}, extent{};
  for (const std::size_t k : {0u, 1u}) {
    const auto [least, most] = std::ranges::minmax(points, {}, [k](const PlanePoint& p) { return p[k]; });
    low[k] = least[k];
    extent[k] = most[k] - least[k];
  }
  const double widest = std::max(extent[0], extent[1]);
  const auto cell = [&](double x, std::size_t k) {
    return static_cast<std::uint32_t>((x - low[k]) / widest * (kCells - 1));
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    places.emplace_back(place_on_curve(cell(points[i][0], 0), cell(points[i][1], 1)), i);
  std::ranges::sort(places);
  std::vector<std::uint32_t> order;
  for (const auto& [place, i] : places) order.push_back(i);
  return order;
}

}  // namespace netloft::gears
