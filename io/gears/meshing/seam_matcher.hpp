// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/equal_points.hpp"

#include <stdexcept>

namespace netloft::gears {

/// A point at a fraction of the length of a side.
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

/// The borders of cloths with their corners, sewn together.
struct Borders {
  const Cloths& cloths;
  EqualPoints points;
  std::vector<std::vector<Break>> breaks;  // points of each side, increasing from 0 to 1
  std::vector<std::array<Row, 2>> seams;   // both sides have the same number of runs between breaks

  std::size_t start(DirectedSide s) const {
    const auto& all = breaks[s.side];
    return s.is_forward ? all.front().point : all.back().point;
  }
  std::size_t end(DirectedSide s) const { return start({s.side, !s.is_forward}); }
};

/// Finds the common points of all seams; corners closer than `snap` [m] along a seam are merged.
Borders sew(const Gear& gear, const Cloths& cloths, double snap);

/// The error, with a sentence for the user, for a seam that joins points of one edge to each other, so that
/// the joined edges cannot lie side by side.
std::invalid_argument cannot_sew(const Gear& gear, const Cloths& cloths, const std::array<Row, 2>& rows);

/// The sides that form an edge, in the direction of the edge. An edge across the middle may have two sides.
Row sides_of(const Cloths& cloths, const EdgeRef& edge);

}  // namespace netloft::gears
