// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/faces.hpp"
#include "io/gears/meshing/gear_mesh.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace netloft::gears {

/// A line of knots between two points. It is divided only once, for all cloths and ropes along it.
struct Line {
  std::array<std::size_t, 2> ends{};  // indices of the end points of the line
  double length = 0;                  // length in half-open netting, or length of rope [m]
  double size = 0;                    // requested size of its elements [m]
  double knots = 0;  // number of bars on the side with more bars, if every knot is a node; otherwise 0
  bool is_netting = false;
  std::vector<double> fractions;  // fractions of its length at its inner nodes, increasing in (0, 1)
};

/// A line, and whether the side or rope that uses it runs in the direction of the line.
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
/// Along a seam, points of both sides correspond if they divide the meshes of their sides in the same
/// proportion; if the panels have different mesh sizes, the lengths of twines are divided instead. A corner
/// on one side becomes a point on both sides; corners on opposite sides that nearly coincide are merged.
struct SeamLines {
  std::vector<Line> lines;
  std::vector<std::vector<SideRun>> sides;  // runs by index in Cloths::sides
  std::vector<std::vector<RopeRun>> ropes;  // runs by index in Gear::ropes
  std::vector<std::array<std::size_t, 2>> rope_ends;
  std::vector<std::size_t> rope_middles;      // middles of ropes across a whole gear; else kNoPoint
  std::map<std::string, std::size_t> points;  // points by name
  std::vector<bool> is_on_plane;              // whether each line is on the plane of symmetry of half a gear
  std::size_t number_of_points = 0;
  Faces faces{0};  // of cloths
};

inline constexpr std::size_t kNoPoint = ~std::size_t{0};

/// Makes and divides the lines of a gear. `size` is the size of elements in half-open netting [m]. Throws
/// CannotDivide if a seam cannot be sewn.
SeamLines seam_lines(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size);

/// Makes the lines of a gear, and divides them like the lines of another gear. Throws std::invalid_argument
/// if the lines of the two gears connect different points.
SeamLines seam_lines_alike(const Gear& gear, const Cloths& cloths, const Fineness& fineness,
                           const MeshTopology& like);

}  // namespace netloft::gears
