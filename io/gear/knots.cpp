// SPDX-License-Identifier: BSD-3-Clause
#include "io/gear/knots.hpp"

#include "io/gear/twine_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::io {

namespace {

constexpr double kNearest = 1.0 / 3;  // bars between a knot and the border, so that no triangle is flat

/// Between the spread plane and twine coordinates, which are linear in one another.
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

double distance_to_side(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const double x = b[0] - a[0], y = b[1] - a[1], l2 = x * x + y * y;
  const double t = l2 > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / l2, 0.0, 1.0) : 0.0;
  return std::hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]);
}

/// A closed border, with its sides by height, so that few of them are looked at for a point.
class BorderSides {
 public:
  BorderSides(const std::vector<PlanePoint>& border, double reach) : border_(border), reach_(reach) {
    low_ = high_ = border.front()[1];
    for (const auto& p : border) low_ = std::min(low_, p[1]), high_ = std::max(high_, p[1]);
    low_ -= reach, high_ += reach;
    bands_.resize(static_cast<std::size_t>((high_ - low_) / reach) + 2);
    for (std::size_t i = 0; i < border.size(); ++i) {
      const auto [a, b] = std::minmax(border[i][1], border[(i + 1) % border.size()][1]);
      for (std::size_t k = band(a - reach); k <= band(b + reach); ++k) bands_[k].push_back(i);
    }
  }

  /// Whether a point is inside, and not within reach of a side.
  bool holds(const PlanePoint& p) const {
    if (p[1] < low_ || p[1] > high_) return false;
    bool is_inside = false;
    for (const std::size_t i : bands_[band(p[1])]) {
      const PlanePoint &a = border_[i], &b = border_[(i + 1) % border_.size()];
      if (distance_to_side(p, a, b) < reach_) return false;
      if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        is_inside = !is_inside;
    }
    return is_inside;
  }

 private:
  std::size_t band(double y) const {
    const double k = std::clamp((y - low_) / reach_, 0.0, static_cast<double>(bands_.size() - 1));
    return static_cast<std::size_t>(k);
  }

  const std::vector<PlanePoint>& border_;
  double reach_, low_, high_;
  std::vector<std::vector<std::size_t>> bands_;
};

}  // namespace

std::vector<PlanePoint> knots_within(const Panel& panel, double sign, const std::vector<PlanePoint>& border) {
  const Lattice lattice(panel, sign);
  double low[2], high[2];
  for (const int k : {0, 1}) low[k] = std::numeric_limits<double>::infinity(), high[k] = -low[k];
  for (const PlanePoint& p : border) {
    const PlanePoint t = lattice.twines(p);
    for (const std::size_t k : {0u, 1u}) low[k] = std::min(low[k], t[k]), high[k] = std::max(high[k], t[k]);
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

}  // namespace netloft::io
