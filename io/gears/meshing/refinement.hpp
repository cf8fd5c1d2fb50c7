// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/delaunay.hpp"

namespace netloft::gears {

/// Adds points inside until each triangle there has sides of at most `longest` and angles of at least 20.7
/// degrees, as far as the held sides, which get no points, allow it. The method is Chew's (Cornell TR
/// 89-983): the worst triangle gets a point at the centre of its circumcircle, unless a held side hides this
/// centre from it. The angle is the largest with which it is known to end: sin² α = 1/8 makes the radius √2
/// times the shortest side, so that no new point is nearer to one that it sees than two points were before.
void refine(Delaunay& mesh, double longest);

}  // namespace netloft::gears
