// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/plane_predicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>
#include <vector>

namespace netloft::gears {

/// A polygon with whole coordinates around the origin, with a hole, and points between its border and the
/// hole.
struct PolygonWithHole {
  std::vector<PlanePoint> border, hole, inside;

  std::vector<PlanePoint> points() const {
    std::vector<PlanePoint> all = border;
    all.insert(all.end(), hole.begin(), hole.end());
    all.insert(all.end(), inside.begin(), inside.end());
    return all;
  }

  /// Twice the area of the border and of the hole.
  std::int64_t twice_area() const {
    double sum = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
      const PlanePoint &a = border[i], &b = border[(i + 1) % border.size()];
      sum += a[0] * b[1] - a[1] * b[0];
    }
    return static_cast<std::int64_t>(sum);
  }
};

/// Draws with a fixed seed.
class RandomPolygons {
 public:
  double between(int least, int most) { return std::uniform_int_distribution(least, most)(engine_); }

  void shuffle(std::vector<PlanePoint>& points) { std::ranges::shuffle(points, engine_); }

  /// At most `number` different points.
  std::vector<PlanePoint> points(int number, int farthest) {
    std::set<PlanePoint> drawn;
    for (int i = 0; i < number; ++i)
      drawn.insert({between(-farthest, farthest), between(-farthest, farthest)});
    return {drawn.begin(), drawn.end()};
  }

  /// Border and hole are star-shaped and mostly far from convex. With a small extent, many points are on one
  /// line or circle, and corners are sharp.
  PolygonWithHole polygon_with_hole(int extent) {
    PolygonWithHole polygon;
    do {
      polygon = {star(extent, 0.5), star(extent, 0.1), {}};
    } while (polygon.border.size() < 3 || polygon.hole.size() < 3 || !holds_hole(polygon));
    std::set<PlanePoint> taken;
    for (const PlanePoint& p : polygon.points()) taken.insert(p);
    for (const PlanePoint& p : points(static_cast<int>(between(0, 30)), extent))
      if (taken.insert(p).second) polygon.inside.push_back(p);
    return polygon;
  }

 private:
  /// Points at growing angles, at distances from the origin between `least` and twice `least` times the
  /// extent.
  std::vector<PlanePoint> star(int extent, double least) {
    const int number = static_cast<int>(between(3, 25));
    std::vector<PlanePoint> ring;
    for (int i = 0; i < number; ++i) {
      const double angle = 2 * std::numbers::pi * i / number,
                   radius = extent * least * (1 + between(0, 100) / 100.0);
      const PlanePoint p{std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))};
      const bool turns_on =
          ring.empty() || (turn({0, 0}, ring.back(), p) > 0 && turn({0, 0}, p, ring[0]) != 0);
      if (p != PlanePoint{0, 0} && turns_on) ring.push_back(p);
    }
    return ring;
  }

  /// Whether the border contains the hole and the origin.
  static bool holds_hole(const PolygonWithHole& polygon) {
    for (const auto* ring : {&polygon.border, &polygon.hole})
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const PlanePoint &a = (*ring)[i], &b = (*ring)[(i + 1) % ring->size()];
        if (turn({0, 0}, a, b) <= 0) return false;
        for (const PlanePoint& c : polygon.hole)
          if (ring == &polygon.border && turn(a, b, c) <= 0 && turn({0, 0}, a, c) >= 0 &&
              turn({0, 0}, b, c) <= 0)
            return false;
        for (const PlanePoint& c : polygon.border)
          if (ring == &polygon.hole && turn(a, b, c) >= 0 && turn({0, 0}, a, c) >= 0 &&
              turn({0, 0}, b, c) <= 0)
            return false;
      }
    return true;
  }

  std::mt19937_64 engine_{1};
};

}  // namespace netloft::gears
