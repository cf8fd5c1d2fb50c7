// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/seam_matcher.hpp"

#include <map>
#include <string>

namespace netloft::io {

/// A stretch of rope along a side, or free (no side), and the length of rope that it takes [m].
struct RopeStretch {
  DirectedSide along;
  bool is_free = false;
  std::size_t from = 0, to = 0;  // points
  double length = 0;
};

/// The way of a rope through the gear, from its start to its end.
using RopeCourse = std::vector<RopeStretch>;

struct RopeCourses {
  std::vector<RopeCourse> courses;            // in the order of the gear
  std::map<std::string, std::size_t> points;  // ends of ropes, corners of panels and points of the plan
};

/// Ropes along their hung edges, in that direction in which these meet one another and what the rope is tied
/// to. What is longer than its edges is free where these do not meet, or else where it is not tied to them:
/// at its end, and of a rope of the middle at both. Less than 2 % (check.hpp) is shared out among the edges.
RopeCourses run_ropes(const Gear& gear, Borders& borders);

}  // namespace netloft::io
