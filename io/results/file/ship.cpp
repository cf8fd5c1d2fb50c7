// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/ship.hpp"

#include "io/results/file/rope_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace netloft::results {

namespace {

using Point = std::array<double, 3>;

// Blocks that are farther apart than the widest trawler belong to two ships.
constexpr double kWidestShip = 40;  // width of a ship [m]
// Beams [m]: the least beam of a single ship, and the beam of each of two ships.
constexpr double kNarrowestShip = 4, kBeam = 10;

// Outlines of hull and house. The coordinates of a point are its distance ahead of the stern, divided by the
// length, and its distance to starboard, divided by half the beam.
const std::vector<std::array<double, 2>> kHull = {{0, 1},       {0.65, 1},  {0.87, 0.6}, {1, 0},
                                                  {0.87, -0.6}, {0.65, -1}, {0, -1}},
                                         kHouse = {{0.5, 0.7}, {0.7, 0.7}, {0.7, -0.7}, {0.5, -0.7}};

/// The names of the warps in a result; empty if no ship tows the gear.
std::set<std::string> warps_of(const StoredShape& stored) {
  std::set<std::string> warps;
  bool has_ship = false;
  for (const auto& figure : stored.result.figures) {
    has_ship |= figure.name.starts_with("towing/");
    if (!figure.name.starts_with("warps/")) continue;
    const std::size_t begin = figure.name.find('/') + 1;
    warps.insert(figure.name.substr(begin, figure.name.rfind('/') - begin));
  }
  return has_ship ? warps : std::set<std::string>{};
}

/// The upper ends of the warps, which are at the blocks; for a half gear, also their mirror images.
std::vector<Point> blocks_of(const StoredShape& stored, std::size_t state) {
  std::vector<Point> blocks;
  const auto points = stored.points(state);
  for (const auto& warp : warps_of(stored)) {
    const auto nodes = nodes_of_rope(stored, warp);
    if (nodes.empty()) continue;
    const auto place = [&](std::uint32_t node) {
      return Point{points[3 * node], points[3 * node + 1], points[3 * node + 2]};
    };
    const Point one = place(nodes.front()), other = place(nodes.back());
    blocks.push_back(one[2] > other[2] ? one : other);
    if (stored.result.is_half()) blocks.push_back({blocks.back()[0], -blocks.back()[1], blocks.back()[2]});
  }
  return blocks;
}

/// Adds a prism between two outlines with equally many corners, closed above and below.
void add_prism(const std::vector<Point>& below, const std::vector<Point>& above, std::vector<Point>& out) {
  for (std::size_t i = 0; i < below.size(); ++i) {
    const std::size_t next = (i + 1) % below.size();
    out.insert(out.end(), {below[i], below[next], above[i], above[i], below[next], above[next]});
  }
  for (const auto* face : {&below, &above})
    for (std::size_t i = 2; i < face->size(); ++i)
      out.insert(out.end(), {(*face)[0], (*face)[i - 1], (*face)[i]});
}

}  // namespace

std::vector<TowingShip> ships_of(const StoredShape& stored, std::size_t state) {
  const auto blocks = blocks_of(stored, state);
  if (blocks.empty()) return {};
  const auto [port, starboard] = std::minmax_element(
      blocks.begin(), blocks.end(), [](const Point& a, const Point& b) { return a[1] < b[1]; });
  const double gap = (*starboard)[1] - (*port)[1];
  if (gap > kWidestShip) return {{*port, kBeam}, {*starboard, kBeam}};
  const Point middle{(*port)[0], ((*port)[1] + (*starboard)[1]) / 2, (*port)[2]};
  return {{middle, std::max(gap, kNarrowestShip)}};
}

std::vector<Point> triangles_of(const TowingShip& ship) {
  const auto [x, y, deck] = ship.stern;
  const double b = ship.beam / 2, length = 4 * ship.beam, keel = std::min(0.0, deck) - 0.7 * b;
  const auto outline = [&, x = x, y = y](const std::vector<std::array<double, 2>>& corners, double wide,
                                         double z) {
    std::vector<Point> out;
    for (const auto& [ahead, aside] : corners) out.push_back({x - ahead * length, y + aside * wide * b, z});
    return out;
  };
  std::vector<Point> triangles;
  add_prism(outline(kHull, 0.6, keel), outline(kHull, 1, deck), triangles);
  add_prism(outline(kHouse, 1, deck), outline(kHouse, 1, deck + 1.2 * b), triangles);
  return triangles;
}

}  // namespace netloft::results
