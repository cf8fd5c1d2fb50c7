// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/triangulation.hpp"

namespace netloft::gears {

/// A closed border, with its sides by height, so that few of them are looked at for a point. The border must
/// live as long as this.
class BorderSides {
 public:
  /// `reach`, above zero: how near to a side a point counts as outside.
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
