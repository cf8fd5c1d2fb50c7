// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace netloft::gears {

using PlanePoint = std::array<double, 2>;

/// Triangles in the plane: first the points of the border as given, then those inside.
struct PlaneMesh {
  std::vector<PlanePoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise
};

/// Fills a closed border, counter-clockwise and without crossings, with triangles of sides of about `size`;
/// near finer borders they are finer. No point is added to the border. Corners of 50 degrees or more are
/// divided between triangles, so that pieces which meet at the corner have more than its two sides in common.
/// Throws std::invalid_argument on a border that crosses itself.
PlaneMesh triangulate(const std::vector<PlanePoint>& border, double size);

/// Connects a border and given points inside by Delaunay's triangles; corners are divided as above.
PlaneMesh connect_points(const std::vector<PlanePoint>& border, const std::vector<PlanePoint>& inside);

enum class Smoothing { none, all };

/// Returns the same triangles with an additional point in the middle of some sides, given by their end
/// points; then points inside are smoothed, or none is.
PlaneMesh split_sides(const PlaneMesh& mesh, std::size_t border, double size,
                      const std::vector<std::array<std::uint32_t, 2>>& sides,
                      Smoothing smoothing = Smoothing::all);

/// The angles of one triangle [rad].
std::array<double, 3> angles_of(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

}  // namespace netloft::gears
