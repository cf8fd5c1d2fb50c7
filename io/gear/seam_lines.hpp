// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/cloths.hpp"
#include "io/gear/gear_mesh.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace netloft::io {

/// A line of knots between two points, divided once, whatever is sewn to it or hung on it.
struct Line {
  std::array<std::size_t, 2> ends{};  // points
  double length = 0;                  // where netting is spread, or of rope [m]
  double size = 0;                    // wanted of its elements [m]
  bool is_netting = false;
  std::vector<double> shares;  // of its nodes between both ends, ascending in (0, 1)
};

/// A line as one that uses it runs along it.
struct Run {
  std::size_t line = 0;
  bool is_forward = true;
};

/// A run along a side of a cloth, from and to shares of that side.
struct SideRun : Run {
  double from = 0, to = 1;
};

/// A run of a rope, and the length of rope that it takes [m].
struct RopeRun : Run {
  double length = 0;
};

/// All lines of a gear. Points are numbers; those that are one have the same number.
///
/// Sides that are sewn together are matched by the share of their meshes (if they are of one size, or both
/// lie across) or of their twines' length, as check.hpp compares them. Where a corner is on one side only
/// there is a point on both; corners of both sides that nearly coincide are one.
struct SeamLines {
  std::vector<Line> lines;
  std::vector<std::vector<SideRun>> sides;  // by the numbers of Cloths::sides
  std::vector<std::vector<RopeRun>> ropes;  // by the numbers of Gear::ropes
  std::vector<std::array<std::size_t, 2>> rope_ends;
  std::vector<std::size_t> rope_middles;      // of those of the middle in the whole; else kNoPoint
  std::map<std::string, std::size_t> points;  // by name
  std::vector<bool> is_on_plane;              // of a half, by line
  std::size_t number_of_points = 0;
};

inline constexpr std::size_t kNoPoint = ~std::size_t{0};

/// `size` [m] where netting is spread; lines are divided, too.
SeamLines seam_lines(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size);

}  // namespace netloft::io
