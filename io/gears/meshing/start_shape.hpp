// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/girth.hpp"
#include "io/gears/meshing/knot_graph.hpp"

#include <bit>
#include <vector>

namespace netloft::gears {

/// A known coordinate of a node, from the plan or from the scene.
struct KnownCoordinate {
  std::uint32_t node = 0;  // node of the gear
  int axis = 0;            // 0, 1, 2: aft, to starboard, up
  double value = 0;        // [m]
  /// Values are compared bit by bit: 0 differs from -0.
  bool operator==(const KnownCoordinate& other) const {
    return node == other.node && axis == other.axis &&
           std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other.value);
  }
};

/// A path along ropes from a point off the netting to the netting.
struct Lead {
  std::uint32_t from, to;
  double length;  // [m]
  std::vector<std::pair<std::uint32_t, double>>
      between;  // nodes from `to` back, with their distances from `from` [m]
};

/// Data of ropes that do not depend on the shape, and the last few sets of leads, by their start nodes.
struct StoredRopes {
  std::vector<std::vector<std::size_t>> at_nodes;  // for each node, the indices of the ropes to which it
                                                   // belongs
  Recent<std::vector<std::uint32_t>, const std::vector<Lead>> leads{4};
};

/// Makes initial positions of the nodes of a divided gear, 3 per node [m]: x aft, y to starboard, z up. The
/// shape need not be accurate, but it must have no kinks or folds, each node must be on its side of the gear,
/// and the size must be about that of the gear.
///
/// Two fields on the nodes of the netting are fitted by least squares to (1) and (2) on the sides of all
/// triangles. An exact solution need not exist, because panels that are sewn together may have different
/// lengths:
///   a_j − a_i = cos β m (V_j − V_i)              metres aft                        (1)
///   s_j − s_i = ± sin β m (|U_j| − |U_i|)        metres of girth from the top      (2)
/// m [m] mesh size, β half angle of the meshes of a trawl at work; U, V [meshes] across and deep. The seams
/// determine the sign in (2): it changes at seams that join two outer or two inner sides, such as from top to
/// bottom. S(a), half the girth, is s on the lower middle line, which may be a seam between port and
/// starboard.
///   φ = π s/S,  y = ± w sin φ,  z = h cos φ,  h = k w                              (3)
/// (3) puts the netting on rings of half width w and half height h, k = 0.4: half an ellipse with the arc
/// length S on each side. At an end that is closed by a seam, z = 0.
///
/// The netting is then shifted to known coordinates of its nodes. If its nodes have none, the shift makes
/// ropes to known points straight and its lowest point as deep as the lowest known point. Known coordinates,
/// including sketches of panels, then get their values; other nodes follow by displacements that are harmonic
/// on the net. Ropes beside the netting are straight.
///
/// The fields, their factorised matrix and the last few shapes are stored for reuse.
class StartShapes {
 public:
  /// `gear` and its `mesh` must outlive this object.
  StartShapes(const Gear& gear, const GearMesh& mesh);

  /// The initial shape for the coordinates `known` from the caller, which have priority, and for the points
  /// and sketches in `placed`. `placed` may differ from the divided gear only in these points and sketches.
  std::vector<double> with(const Gear& placed, const std::vector<KnownCoordinate>& known = {});

 private:
  const Gear& gear_;
  const GearMesh& mesh_;
  Girth girth_;
  HarmonicFields fields_;
  StoredRopes ropes_;
  const std::vector<double> rings_;  // positions of the netting before it is shifted, 3 per node [m]
  Recent<std::vector<KnownCoordinate>, const std::vector<double>> shapes_{4};
};

}  // namespace netloft::gears
