// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/gear_mesh.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace netloft::gears {

/// A line of knots between two points. It is divided once for everything that is sewn to it or hung on it.
struct Line {
  std::array<std::size_t, 2> ends{};  // points
  double length = 0;                  // length in the spread netting, or length of rope [m]
  double size = 0;                    // requested size of its elements [m]
  double knots =
      0;  // mesh sides along it if every knot is a node (the larger number of both sides); 0: by size
  bool is_netting = false;
  std::vector<double> fractions;  // fractions of its length at its inner nodes, increasing in (0, 1)
};

/// A line, and whether its user (a side or a rope) runs along it in its own direction.
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
/// Points of two sides that are sewn together correspond by the fraction of meshes, if both sides have the
/// same mesh size or lie across, and else by the fraction of twine length, as in check.hpp. A corner on one
/// side becomes a point on both; corners of both sides that nearly coincide are merged.
struct SeamLines {
  std::vector<Line> lines;
  std::vector<std::vector<SideRun>> sides;  // index as in Cloths::sides
  std::vector<std::vector<RopeRun>> ropes;  // index as in Gear::ropes
  std::vector<std::array<std::size_t, 2>> rope_ends;
  std::vector<std::size_t>
      rope_middles;  // middles of ropes of the middle in a whole gear; otherwise kNoPoint
  std::map<std::string, std::size_t> points;  // by name
  std::vector<bool> is_on_plane;              // by line, in half a gear
  std::size_t number_of_points = 0;
};

inline constexpr std::size_t kNoPoint = ~std::size_t{0};

/// Makes and divides the lines of a gear. `size`: size of elements in the spread netting [m].
SeamLines seam_lines(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size);

}  // namespace netloft::gears
