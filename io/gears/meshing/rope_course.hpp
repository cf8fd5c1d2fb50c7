// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/seam_matcher.hpp"

#include <map>
#include <string>

namespace netloft::gears {

/// A stretch of rope along a side, or free (no side), and the length of rope that it takes [m].
struct RopeStretch {
  DirectedSide along;
  bool is_free = false;
  std::size_t from = 0, to = 0;  // points
  double length = 0;
};

/// The course of a rope through the gear, from its start to its end.
using RopeCourse = std::vector<RopeStretch>;

struct RopeCourses {
  std::vector<RopeCourse> courses;            // in the order of the gear
  std::map<std::string, std::size_t> points;  // ends of ropes, corners of panels and points of the plan
};

/// Runs ropes along their hung edges, in the direction in which these meet each other and the points that the
/// rope is tied to. A rope that is longer than its edges has free stretches where its edges do not meet,
/// otherwise at ends that are not tied: at its end, or at both ends for a rope of the middle. Less than 2 %
/// (check.hpp) is distributed among the edges.
RopeCourses run_ropes(const Gear& gear, Borders& borders);

}  // namespace netloft::gears
