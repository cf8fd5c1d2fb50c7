// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

namespace netloft::gears {

using PlanePoint = std::array<double, 2>;

// The signs of two determinants, without rounding errors: they are exact if the coordinates are below 2^250
// and multiples of 2^-268. Most signs are decided in double precision, by Shewchuk's error bounds (Discrete
// Comput. Geom. 18 (1997) 305).

/// 1 if a, b, c turn to the left, -1 if they turn to the right, 0 if they lie on one line.
int turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// 1 if d lies within the circle through a, b, c, which turn to the left, -1 if it lies outside, 0 if it lies
/// on it.
int in_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);

/// Like in_circle() for four different points, but never 0 if three of them turn to the left. Each point is
/// lifted from the paraboloid by an infinitesimal amount; in the order by x, then y, each amount is
/// infinitely larger than the previous one (Devillers and Teillaud, Comput. Geom. 44 (2011) 160). The
/// Delaunay triangulation of different points is thus unique.
int in_lifted_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);

}  // namespace netloft::gears
