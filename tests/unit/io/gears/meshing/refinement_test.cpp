// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/refinement.hpp"

#include "tests/unit/io/gears/meshing/random_polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace netloft::gears {
namespace {

double length(const PlanePoint& a, const PlanePoint& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

Delaunay within(const std::vector<PlanePoint>& border) {
  Delaunay mesh(border);
  for (std::size_t i = 0; i < border.size(); ++i)
    mesh.hold(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>((i + 1) % border.size()));
  mesh.mark_inside();
  return mesh;
}

/// The centre of the circumcircle as the point where two perpendicular bisectors meet.
PlanePoint centre(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - a[0], vy = c[1] - a[1],
               det = ux * vy - uy * vx;
  const double u = (ux * (a[0] + b[0]) + uy * (a[1] + b[1])) / 2,
               v = (vx * (a[0] + c[0]) + vy * (a[1] + c[1])) / 2;
  return {(u * vy - v * uy) / det, (ux * v - vx * u) / det};
}

/// Whether a triangle satisfies the bounds or no point could improve it.
bool is_done(const Delaunay& mesh, std::uint32_t t, double longest) {
  const auto& corners = mesh.triangles()[t].corners;
  std::array<PlanePoint, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.points()[corners[k]];
  std::array<double, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) sides[k] = length(p[(k + 1) % 3], p[(k + 2) % 3]);
  const PlanePoint middle = centre(p[0], p[1], p[2]);
  const double radius = length(middle, p[0]);
  const auto [least, most] = std::ranges::minmax_element(sides);
  constexpr double kRounding = 1 + 1e-9;
  if (*most <= longest * kRounding && radius <= std::sqrt(2.0) * *least * kRounding) return true;
  return mesh.seen_from(t, static_cast<int>(most - sides.begin()), middle) == Delaunay::kFar;
}

TEST(Refinement, EndsForBadAnglesAndLeavesOnlyTrianglesThatNoPointCouldImprove) {
  RandomPolygons draws;
  std::size_t added = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto border = draws.polygon_with_hole(i % 2 == 0 ? 12 : 1000).border;
    Delaunay mesh = within(border);
    const double longest = (i % 2 == 0 ? 12 : 1000) * (i % 3 == 0 ? 0.1 : 1);
    refine(mesh, longest);
    added += mesh.points().size() - border.size();
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
      ASSERT_TRUE(!mesh.triangles()[t].is_inside || is_done(mesh, t, longest)) << i;
  }
  EXPECT_GT(added, 10000);
}

TEST(Refinement, AddsNoPointNearerToAnotherThanPointsWereBefore) {
  RandomPolygons draws;
  std::size_t added = 0;
  for (int i = 0; i < 300; ++i) {
    const auto border = draws.polygon_with_hole(1000).border;
    double least = 1e9;
    for (std::size_t k = 0; k < border.size(); ++k)
      for (std::size_t n = 0; n < k; ++n) least = std::min(least, length(border[k], border[n]));
    Delaunay mesh = within(border);
    refine(mesh, 2 * least);
    added += mesh.points().size() - border.size();
    for (const auto& t : mesh.triangles())
      for (std::size_t k = 0; k < 3 && t.is_inside; ++k)
        ASSERT_GE(length(mesh.points()[t.corners[k]], mesh.points()[t.corners[(k + 1) % 3]]),
                  least * (1 - 1e-9))
            << i;
  }
}

// A corner of 0.1 degrees, and a border that is much finer at one end: the triangles in the corner stay bad,
// but must stay few.
TEST(Refinement, EndsInASharpCorner) {
  std::vector<PlanePoint> border{{0, 0}};
  for (int k = 1; k <= 50; ++k) border.push_back({k * 0.01, 0});
  border.push_back({1, 0});
  border.push_back({1, 0.0017});
  Delaunay mesh = within(border);
  refine(mesh, 1);
  EXPECT_LT(mesh.points().size(), 2 * border.size());
}

// Triangles in a square with a regular border have no angle below 20.7 degrees, which is Chew's bound.
TEST(Refinement, MakesGoodTrianglesWithinARegularBorder) {
  std::vector<PlanePoint> border;
  constexpr int kParts = 20;
  const std::array<PlanePoint, 5> square{{{0, 0}, {kParts, 0}, {kParts, kParts}, {0, kParts}, {0, 0}}};
  for (std::size_t s = 0; s < 4; ++s)
    for (int k = 0; k < kParts; ++k)
      border.push_back({square[s][0] + (square[s + 1][0] - square[s][0]) * k / kParts,
                        square[s][1] + (square[s + 1][1] - square[s][1]) * k / kParts});
  Delaunay mesh = within(border);
  refine(mesh, 1.35);
  for (const auto& t : mesh.triangles()) {
    if (!t.is_inside) continue;
    const PlanePoint &a = mesh.points()[t.corners[0]], &b = mesh.points()[t.corners[1]],
                     &c = mesh.points()[t.corners[2]];
    const double radius = length(centre(a, b, c), a),
                 shortest = std::min({length(a, b), length(b, c), length(c, a)});
    EXPECT_LT(std::max({length(a, b), length(b, c), length(c, a)}), 1.35 * (1 + 1e-9));
    EXPECT_LT(radius, std::sqrt(2.0) * shortest * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace netloft::gears
