// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/knots.hpp"

#include "io/gears/meshing/border_sides.hpp"
#include "io/gears/plan/twine_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::gears {

namespace {

constexpr double kNearest = 1.0 / 3;  // least distance to the border [bars], so that no triangle is flat

/// The linear map between positions in half-open netting [m] and coordinates along the twines [bars].
class Lattice {
 public:
  Lattice(const Panel& panel, double sign) {
    const PanelPoint unit = spread(panel, {1, 1});
    const auto across = twine_coordinates(panel.orientation, panel.angle, sign / unit.x, 0);
    const auto deep = twine_coordinates(panel.orientation, panel.angle, 0, 1 / unit.y);
    to_ = {across[0], deep[0], across[1], deep[1]};
    const double det = to_[0] * to_[3] - to_[1] * to_[2];
    from_ = {to_[3] / det, -to_[1] / det, -to_[2] / det, to_[0] / det};
  }
  PlanePoint twines(const PlanePoint& p) const {
    return {to_[0] * p[0] + to_[1] * p[1], to_[2] * p[0] + to_[3] * p[1]};
  }
  PlanePoint plane(double u, double v) const {
    return {from_[0] * u + from_[1] * v, from_[2] * u + from_[3] * v};
  }

 private:
  std::array<double, 4> to_{}, from_{};
};

}  // namespace

std::vector<PlanePoint> knots_within(const Panel& panel, double sign, const std::vector<PlanePoint>& border) {
  const Lattice lattice(panel, sign);
  double low[2], high[2];
  for (const int k : {0, 1}) {
    low[k] = std::numeric_limits<double>::infinity();
    high[k] = -low[k];
  }
  for (const PlanePoint& p : border) {
    const PlanePoint t = lattice.twines(p);
    for (const std::size_t k : {0u, 1u}) {
      low[k] = std::min(low[k], t[k]);
      high[k] = std::max(high[k], t[k]);
    }
  }
  const BorderSides sides(border, kNearest * panel.mesh / 2);
  std::vector<PlanePoint> knots;
  for (double u = std::ceil(low[0]); u <= high[0]; ++u)
    for (double v = std::ceil(low[1]); v <= high[1]; ++v)
      if (const PlanePoint p = lattice.plane(u, v); sides.holds(p)) knots.push_back(p);
  return knots;
}

double knots_along(const Panel& panel, double sign, const PanelPoint& from, const PanelPoint& to) {
  const auto a = twine_coordinates(panel.orientation, panel.angle, sign * from.x, from.y),
             b = twine_coordinates(panel.orientation, panel.angle, sign * to.x, to.y);
  return std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1]));
}

}  // namespace netloft::gears
