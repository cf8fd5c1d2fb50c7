// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/delaunay.hpp"

namespace netloft::gears {

/// Adds inner points until each triangle has sides of at most `longest` and angles of at least 20.7 degrees.
/// Held sides get no points, so that triangles at them may stay worse. The method is Chew's (Cornell TR
/// 89-983): the worst triangle gets a point at the centre of its circumcircle, unless a held side is between
/// the triangle and this centre. The angle α is the largest for which the method is known to end: with sin² α
/// = 1/8, the radius is √2 times the shortest side, so that a new point is never closer to points that it can
/// see than earlier points were to each other.
void refine(Delaunay& mesh, double longest);

}  // namespace netloft::gears
