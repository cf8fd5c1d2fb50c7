// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/gear_mesh.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace netloft::gears {

/// A line of knots between two points, divided once for all that is sewn to it or hung on it.
struct Line {
  std::array<std::size_t, 2> ends{};  // points
  double length = 0;                  // in the spread netting, or of rope [m]
  double size = 0;                    // wanted size of its elements [m]
  double knots = 0;  // where every knot is a node: along it, of the side that has more; 0: by size
  bool is_netting = false;
  std::vector<double> fractions;  // fractions of its length at its inner nodes, increasing in (0, 1)
};

/// A line in the direction in which a user of the line runs along it.
struct Run {
  std::size_t line = 0;
  bool is_forward = true;
};

/// A run along a side of a cloth, between two fractions of that side.
struct SideRun : Run {
  double from = 0, to = 1;
};

/// A run of a rope, and the length of rope that it takes [m].
struct RopeRun : Run {
  double length = 0;
};

/// All lines of a gear. Points are indices; identical points have the same index.
///
/// Sides that are sewn together are matched by the fraction of their meshes (if they have the same mesh size,
/// or both lie across) or of their twine length, in agreement with check.hpp. A corner on one side gives a
/// point on both; corners of both sides that nearly coincide are merged.
struct SeamLines {
  std::vector<Line> lines;
  std::vector<std::vector<SideRun>> sides;  // index as in Cloths::sides
  std::vector<std::vector<RopeRun>> ropes;  // index as in Gear::ropes
  std::vector<std::array<std::size_t, 2>> rope_ends;
  std::vector<std::size_t> rope_middles;      // of ropes of the middle in the whole; otherwise kNoPoint
  std::map<std::string, std::size_t> points;  // by name
  std::vector<bool> is_on_plane;              // of the half, one per line
  std::size_t number_of_points = 0;
};

inline constexpr std::size_t kNoPoint = ~std::size_t{0};

/// `size` [m] is that in the spread netting; lines are divided, too.
SeamLines seam_lines(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size);

}  // namespace netloft::gears
