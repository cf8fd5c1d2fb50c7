// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/seam_matcher.hpp"

#include <map>
#include <string>

namespace netloft::gears {

/// A stretch of rope, along a side of a cloth (cloths.hpp) or free, and the length of rope that it takes [m].
struct RopeStretch {
  DirectedSide along;
  bool is_free = false;
  std::size_t from = 0, to = 0;  // indices of its end points
  double length = 0;
};

/// The course of a rope through the gear, from its start to its end.
using RopeCourse = std::vector<RopeStretch>;

struct RopeCourses {
  std::vector<RopeCourse> courses;            // courses in the order of the gear's ropes
  std::map<std::string, std::size_t> points;  // ends of ropes, corners of panels and points of the plan
};

/// Finds the courses of ropes along the edges hung on them. The direction of each edge is chosen so that
/// edges meet each other and the points to which the rope is tied. If a rope is longer than its edges, the
/// excess becomes free stretches between consecutive edges that do not meet. If all edges meet, the free
/// stretches are at ends that are not tied: at both ends of a rope across the middle, or at the end of
/// another rope. An excess below 2 % of the rope is distributed among the edges instead.
RopeCourses run_ropes(const Gear& gear, Borders& borders);

}  // namespace netloft::gears
