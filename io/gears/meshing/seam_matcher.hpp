// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/equal_points.hpp"

#include <optional>

namespace netloft::gears {

/// A point that divides a side of a cloth, at a fraction of the length of the side.
struct Break {
  double fraction = 0;
  std::size_t point = 0;
};

/// A side in the direction in which a seam or a rope runs along it.
struct DirectedSide {
  std::size_t side = 0;
  bool is_forward = true;
};
using Row = std::vector<DirectedSide>;

/// Two rows of sides that are sewn together.
struct SewnRows {
  std::array<Row, 2> rows;
  std::optional<std::size_t> join;  // index in NetPlan::joins; nullopt for the two halves of a middle panel
  bool is_of_layer = false;         // Seam::is_of_layer
};

/// The borders of cloths with their corners, sewn together.
struct Borders {
  const Cloths& cloths;
  EqualPoints points;
  std::vector<std::vector<Break>> breaks;  // points on each side, with fractions increasing from 0 to 1
  std::vector<SewnRows> seams;             // both rows have the same number of runs between breaks

  std::size_t start(DirectedSide s) const {
    const auto& all = breaks[s.side];
    return s.is_forward ? all.front().point : all.back().point;
  }
  std::size_t end(DirectedSide s) const { return start({s.side, !s.is_forward}); }
};

/// Finds the common points of all seams; corners closer than `snap` [m] along a seam are merged.
///
/// Rows, the two sides of a seam, run outwards along fore and aft edges, and aft along sides. If sides are
/// sewn to a fore or aft edge and the net would be twisted (faces.hpp), they run forward instead. The port
/// half of a row from port to starboard runs in the opposite direction, because it mirrors the starboard
/// half.
Borders sew(const Gear& gear, const Cloths& cloths, double snap);

/// The name of the first edge of a row.
std::string name_of(const Gear& gear, const Cloths& cloths, const Row& row);

/// Throws CannotDivide for a seam that joins points of one of its edges to each other, so that the two rows
/// cannot lie side by side.
[[noreturn]] void refuse_seam(const Gear& gear, const Cloths& cloths, const SewnRows& seam);

/// The sides that form an edge, in the direction of the edge. An edge across the middle may have two sides.
Row sides_of(const Cloths& cloths, const EdgeRef& edge);

}  // namespace netloft::gears
