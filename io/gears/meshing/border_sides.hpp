// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/triangulation.hpp"

namespace netloft::gears {

/// A closed border. Its sides are sorted into bands of height, so that a point is tested only against the
/// sides in its band. The border must outlive this object.
class BorderSides {
 public:
  /// `reach` > 0: a point that is nearer than this to a side counts as outside.
  BorderSides(const std::vector<PlanePoint>& border, double reach);

  /// Whether a point is inside, and not within reach of a side.
  bool holds(const PlanePoint& p) const;

 private:
  std::size_t band(double y) const;

  const std::vector<PlanePoint>& border_;
  double reach_, low_, high_;
  std::vector<std::vector<std::size_t>> bands_;
};

}  // namespace netloft::gears
