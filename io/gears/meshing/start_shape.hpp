// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/girth.hpp"
#include "io/gears/meshing/knot_graph.hpp"

#include <bit>
#include <vector>

namespace netloft::gears {

/// A given coordinate of a node, of a point of the plan or from the scene.
struct KnownCoordinate {
  std::uint32_t node = 0;  // of the gear
  int axis = 0;            // 0, 1, 2: aft, to starboard, up
  double value = 0;        // [m]
  /// Values are compared bit by bit: 0 differs from -0.
  bool operator==(const KnownCoordinate& other) const {
    return node == other.node && axis == other.axis &&
           std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other.value);
  }
};

/// Makes initial positions of the nodes of a divided gear, 3 per node [m]: x aft, y to starboard, z up. They
/// need not be accurate, but must be free of kinks and folds, on the right side, and about as large as the
/// gear.
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
///
/// Fields, factors and the last few shapes are kept for the next one.
class StartShapes {
 public:
  /// `gear` and its `mesh` must live longer.
  StartShapes(const Gear& gear, const GearMesh& mesh);

  /// The shape for coordinates known to the caller, which have priority, and for the points and sketches of
  /// `placed`: a gear that differs in these, if at all, from the one that was divided.
  std::vector<double> with(const Gear& placed, const std::vector<KnownCoordinate>& known = {});

 private:
  const Gear& gear_;
  const GearMesh& mesh_;
  Girth girth_;
  HarmonicFields fields_;
  Recent<std::vector<KnownCoordinate>, const std::vector<double>> shapes_{4};
};

}  // namespace netloft::gears
