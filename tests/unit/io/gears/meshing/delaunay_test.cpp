// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/delaunay.hpp"

#include "tests/unit/io/gears/meshing/random_polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace netloft::gears {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Ends = std::pair<std::uint32_t, std::uint32_t>;

bool is_far(const Delaunay::Triangle& t) { return std::ranges::count(t.corners, Delaunay::kFar) > 0; }

/// Triangles with whole coordinates have exact areas.
std::int64_t twice_area(const Delaunay& mesh, const Corners& t) {
  const PlanePoint &a = mesh.points()[t[0]], &b = mesh.points()[t[1]], &c = mesh.points()[t[2]];
  return static_cast<std::int64_t>((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/// Expects that neighbours agree on their common side, that triangles are counter-clockwise, that each point
/// has a triangle, and that there are as many triangles as Euler's formula says: 2 (n + 1) - 4 with the point
/// kFar.
void expect_whole(const Delaunay& mesh) {
  std::set<std::uint32_t> seen;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    const auto& [corners, across, held, is_inside] = mesh.triangles()[t];
    if (!is_far(mesh.triangles()[t])) {
      ASSERT_GT(turn(mesh.points()[corners[0]], mesh.points()[corners[1]], mesh.points()[corners[2]]), 0);
      seen.insert(corners.begin(), corners.end());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& beyond = mesh.triangles()[across[k]];
      const auto back = std::ranges::find(beyond.across, t) - beyond.across.begin();
      ASSERT_LT(back, 3);
      ASSERT_EQ(beyond.held[static_cast<std::size_t>(back)], held[k]);
      std::set<std::uint32_t> both{corners[(k + 1) % 3], corners[(k + 2) % 3]};
      for (const std::size_t n : {1u, 2u})
        both.erase(beyond.corners[(static_cast<std::size_t>(back) + n) % 3]);
      ASSERT_TRUE(both.empty());
    }
  }
  ASSERT_EQ(seen.size(), mesh.points().size());
  ASSERT_EQ(mesh.triangles().size(), 2 * (mesh.points().size() + 1) - 4);
}

/// Expects that no circumcircle contains the vertex opposite a side that is not fixed; a triangulation with
/// this property is the constrained Delaunay triangulation (Lee and Lin, Discrete Comput. Geom. 1 (1986)
/// 201).
void expect_delaunay(const Delaunay& mesh) {
  const auto& points = mesh.points();
  for (std::uint32_t number = 0; number < mesh.triangles().size(); ++number)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = mesh.triangles()[number];
      const auto& beyond = mesh.triangles()[t.across[k]];
      if (t.held[k] || is_far(t) || is_far(beyond)) continue;
      const auto back =
          static_cast<std::size_t>(std::ranges::find(beyond.across, number) - beyond.across.begin());
      const PlanePoint &a = points[t.corners[0]], &b = points[t.corners[1]], &c = points[t.corners[2]];
      ASSERT_EQ(in_lifted_circle(a, b, c, points[beyond.corners[back]]), -1);
    }
}

std::set<Ends> held_sides(const Delaunay& mesh) {
  std::set<Ends> sides;
  for (const auto& t : mesh.triangles())
    for (std::size_t k = 0; k < 3; ++k)
      if (t.held[k]) sides.insert(std::minmax(t.corners[(k + 1) % 3], t.corners[(k + 2) % 3]));
  return sides;
}

std::int64_t twice_area_inside(const Delaunay& mesh) {
  std::int64_t sum = 0;
  for (const auto& t : mesh.triangles())
    if (t.is_inside) sum += twice_area(mesh, t.corners);
  return sum;
}

std::set<std::set<PlanePoint>> triangles_of(const Delaunay& mesh) {
  std::set<std::set<PlanePoint>> triangles;
  for (const auto& t : mesh.triangles())
    if (!is_far(t)) {
      std::set<PlanePoint> corners;
      for (const std::uint32_t v : t.corners) corners.insert(mesh.points()[v]);
      triangles.insert(corners);
    }
  return triangles;
}

void hold_ring(Delaunay& mesh, std::size_t first, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    mesh.hold(static_cast<std::uint32_t>(first + i), static_cast<std::uint32_t>(first + (i + 1) % size));
}

TEST(Delaunay, HoldsTheSidesOfRandomPolygonsWithHolesAndPointsInside) {
  RandomPolygons draws;
  int filled = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto polygon = draws.polygon_with_hole(i % 2 == 0 ? 12 : 1000);
    Delaunay mesh(polygon.points());
    expect_delaunay(mesh);
    hold_ring(mesh, 0, polygon.border.size());
    hold_ring(mesh, polygon.border.size(), polygon.hole.size());
    mesh.mark_inside();
    ASSERT_NO_FATAL_FAILURE(expect_whole(mesh)) << i;
    ASSERT_NO_FATAL_FAILURE(expect_delaunay(mesh)) << i;
    ASSERT_EQ(twice_area_inside(mesh), polygon.twice_area()) << i;
    ASSERT_GE(held_sides(mesh).size(), polygon.border.size() + polygon.hole.size()) << i;
    filled += polygon.inside.empty() ? 0 : 1;
  }
  EXPECT_GT(filled, 1000);
}

TEST(Delaunay, DependsOnThePointsAndNotOnTheirOrder) {
  RandomPolygons draws;
  for (int i = 0; i < 1000; ++i) {
    std::vector<PlanePoint> points =
        draws.points(60, 8);  // on a grid of 17 by 17, so that many are on one circle or line
    const auto first = triangles_of(Delaunay(points));
    draws.shuffle(points);
    ASSERT_EQ(triangles_of(Delaunay(points)), first) << i;
  }
}

TEST(Delaunay, DividesAHeldLineAtPointsOnIt) {
  Delaunay mesh({{0, 0}, {4, 0}, {2, 0}, {1, 3}, {3, -3}, {1, 0}});
  mesh.hold(0, 1);
  EXPECT_EQ(held_sides(mesh), (std::set<Ends>{{0, 5}, {2, 5}, {1, 2}}));
}

TEST(Delaunay, RefusesHeldLinesThatCross) {
  Delaunay mesh({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  mesh.hold(0, 2);
  EXPECT_THROW(mesh.hold(1, 3), std::invalid_argument);
}

TEST(Delaunay, RefusesPointsThatCoincideOrLieOnOneLine) {
  EXPECT_THROW(Delaunay({{0, 0}, {1, 0}, {0, 1}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(Delaunay({{0, 0}, {1, 1}, {2, 2}, {5, 5}}), std::invalid_argument);
  EXPECT_THROW(Delaunay({{0, 0}, {1, 1}}), std::invalid_argument);
}

TEST(Delaunay, IsRestoredAfterPointsMoved) {
  RandomPolygons draws;
  for (int i = 0; i < 300; ++i) {
    const PolygonWithHole polygon{draws.polygon_with_hole(1000).border, {}, draws.points(30, 150)};
    Delaunay mesh(polygon.points());
    hold_ring(mesh, 0, polygon.border.size());
    for (std::size_t v = polygon.border.size(); v < mesh.points().size(); ++v) {
      const PlanePoint before = mesh.points()[v];
      mesh.move(static_cast<std::uint32_t>(v),
                {before[0] + draws.between(-20, 20), before[1] + draws.between(-20, 20)});
      if (std::ranges::any_of(mesh.triangles(),
                              [&](const auto& t) { return !is_far(t) && twice_area(mesh, t.corners) <= 0; }))
        mesh.move(static_cast<std::uint32_t>(v), before);
    }
    mesh.restore();
    Delaunay anew(mesh.points());
    hold_ring(anew, 0, polygon.border.size());
    ASSERT_NO_FATAL_FAILURE(expect_whole(mesh)) << i;
    ASSERT_EQ(triangles_of(mesh), triangles_of(anew)) << i;
  }
}

TEST(Delaunay, SeesPointsUntilAHeldSide) {
  Delaunay mesh({{0, 0}, {4, 0}, {8, 0}, {8, 4}, {4, 4}, {0, 4}});
  mesh.hold(1, 4);
  const auto& triangles = mesh.triangles();
  const auto at_origin = std::ranges::find_if(triangles, [&](const auto& t) {
    return std::ranges::count(t.corners, 0u) > 0 && !is_far(t) &&
           mesh.seen_from(static_cast<std::uint32_t>(&t - triangles.data()),
                          static_cast<int>(std::ranges::find(t.corners, 0u) - t.corners.begin()),
                          {3, 2}) != Delaunay::kFar;
  });
  ASSERT_NE(at_origin, triangles.end());
  const auto t = static_cast<std::uint32_t>(at_origin - triangles.begin());
  const int k = static_cast<int>(std::ranges::find(at_origin->corners, 0u) - at_origin->corners.begin());
  EXPECT_EQ(mesh.seen_from(t, k, {6, 4}), Delaunay::kFar);    // a point behind the fixed side, and one on the
                                                              // hull
  EXPECT_EQ(mesh.seen_from(t, k, {5, 3}), Delaunay::kFar);    // behind the held side
  EXPECT_EQ(mesh.seen_from(t, k, {4, 3}), Delaunay::kFar);    // on the held side
  EXPECT_EQ(mesh.seen_from(t, k, {-1, -1}), Delaunay::kFar);  // the line does not start in the triangle
}

}  // namespace
}  // namespace netloft::gears
