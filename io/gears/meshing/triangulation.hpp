// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/plane_predicates.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::gears {

/// Triangles in the plane. `points`: first those of the border in the given order, then inner points.
struct PlaneMesh {
  std::vector<PlanePoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise
};

/// Fills a closed border with triangles whose sides are about `size` long, or shorter near finer parts of the
/// border. The border must be counter-clockwise; it gets no additional points. Corners of 50 degrees or more
/// are divided between two triangles, so that pieces of netting that meet at a corner share more than its two
/// sides. Throws std::invalid_argument if the border crosses itself.
PlaneMesh triangulate(const std::vector<PlanePoint>& border, double size);

/// Connects a border and given inner points (Delaunay); corners are divided as in triangulate().
PlaneMesh connect_points(const std::vector<PlanePoint>& border, const std::vector<PlanePoint>& inside);

enum class Smoothing { none, all };

/// Adds a point in the middle of each side in `sides`, which are pairs of end points, and connects all points
/// again. `smoothing`: whether inner points are smoothed afterwards.
PlaneMesh split_sides(const PlaneMesh& mesh, std::size_t border, double size,
                      const std::vector<std::array<std::uint32_t, 2>>& sides,
                      Smoothing smoothing = Smoothing::all);

/// Moves the inner points of a mesh with its border, from the points b of the border to b':
///   x' = x + Σ wᵢ(x) (b'ᵢ − bᵢ)                                                         (1)
/// where w are the mean value coordinates of x (Hormann and Floater, ACM Trans. Graph. 25 (2006) 1424):
///   wᵢ ~ [tan(αᵢ₋₁/2) + tan(αᵢ/2)] / |bᵢ − x|,   Σ wᵢ = 1                                 (2)
/// αᵢ is the signed angle at x from bᵢ to bᵢ₊₁. If the motion of the border is affine, all points move by the
/// same affine motion. Throws std::invalid_argument if a triangle is turned over.
PlaneMesh moved_with_border(const PlaneMesh& mesh, const std::vector<PlanePoint>& border);

std::array<double, 3> angles_of(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

}  // namespace netloft::gears
