// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <vector>

namespace netloft::gears {

/// A given coordinate of a node, of a point of the plan or from the scene.
struct KnownCoordinate {
  std::uint32_t node = 0;  // of the gear
  int axis = 0;            // 0, 1, 2: aft, to starboard, up
  double value = 0;        // [m]
};

/// Initial positions of the nodes of a gear, 3 per node [m]: x aft, y to starboard, z up. They need not be
/// accurate, but must be free of kinks and folds, on the right side, and about as large as the gear.
///
/// Two fields on the nodes of the netting, both by least squares over the sides of all triangles, since
/// panels that are sewn together need not fit:
///   a_j − a_i = cos β m (V_j − V_i)              metres aft                        (1)
///   s_j − s_i = ± sin β m (|U_j| − |U_i|)        metres of girth from the top      (2)
/// m [m] mesh size, β the half angle of meshes that are open as in a trawl at work; U, V [meshes] across and
/// deep. The sign in (2) is found by a walk over the seams: it changes across seams of outer with outer or
/// inner with inner sides, as from top to bottom. S(a), half the girth, is s on the lower middle line.
///   φ = π s/S,  y = ± w sin φ,  z = h cos φ,  h = k w                              (3)
/// puts the netting on rings, half an ellipse of the arc S to port and starboard. Where an end is closed by
/// sewing it to itself z = 0.
///
/// The gear as a whole is then placed so that ropes to known points are straight, and its lowest
/// point as deep as the lowest known one. What is known, sketches of panels among it, is put in its place,
/// and all else follows by displacements that are harmonic on the net. Ropes off the netting are straight.
std::vector<double> start_shape(const Gear& gear, const GearMesh& mesh,
                                const std::vector<KnownCoordinate>& known = {});

}  // namespace netloft::gears
