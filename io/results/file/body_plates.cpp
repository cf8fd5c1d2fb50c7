// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/body_plates.hpp"

#include <netloft/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace netloft::results {

namespace {

using Point = std::array<double, 3>;

/// Divides an outline into triangles. The corners of the outline run up one side of the plate and down the
/// other. Every triangle has corners on both sides, so that a cambered plate is curved about its height axis.
std::vector<std::array<std::size_t, 3>> triangles_within(std::size_t corners) {
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t low = 0, high = corners - 1; low + 1 < high; ++low, --high) {
    triangles.push_back({low, low + 1, high});
    if (low + 1 < high - 1) triangles.push_back({low + 1, high - 1, high});
  }
  return triangles;
}

BodyPlate plate_of(const StoredBody& body, std::uint32_t dot, const std::vector<double>& points,
                   const std::vector<double>& rotations) {
  const std::size_t at = 3 * std::size_t{body.origin};
  const Vec3<double> turn{rotations[at], rotations[at + 1], rotations[at + 2]};
  BodyPlate plate{dot};
  for (const auto& triangle : triangles_within(body.outline.size()))
    for (const std::size_t corner : triangle) {
      const auto& [x, y, z] = body.outline[corner];
      const Vec3<double> r = rotated(turn, Vec3<double>{x, y, z});
      plate.triangles.push_back({points[at] + r.x, points[at + 1] + r.y, points[at + 2] + r.z});
    }
  return plate;
}

}  // namespace

std::vector<BodyPlate> plates_of(const StoredShape& stored, std::size_t state) {
  std::vector<BodyPlate> plates;
  if (stored.bodies.empty()) return plates;
  const auto points = stored.points(state), rotations = stored.node_field("rotation", state);
  const auto& dots = stored.mesh.dots;
  for (const auto& body : stored.bodies) {
    const auto dot = std::find(dots.begin(), dots.end(), body.origin);
    if (body.outline.size() < 3 || dot == dots.end() || rotations.empty() ||
        !std::isfinite(rotations[3 * std::size_t{body.origin}]))
      continue;
    plates.push_back(plate_of(body, static_cast<std::uint32_t>(dot - dots.begin()), points, rotations));
  }
  return plates;
}

}  // namespace netloft::results
