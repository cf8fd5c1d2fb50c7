// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/carried_gear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace netloft::runs {

namespace {

using Place = std::array<double, 2>;    // twine coordinates (u, v)
using Weights = std::array<double, 3>;  // weights of the corners of a triangle; their sum is one

/// The triangles of a panel in the plane of its twine coordinates. A grid of cells lists the triangles near
/// each cell.
class Netting {
 public:
  explicit Netting(const Part& part)
      : part_(part), u_(part.data.at(datum::kU.name)), v_(part.data.at(datum::kV.name)) {}

  std::size_t triangles() const { return part_.nodes.size() / 3; }
  Place corner(std::size_t triangle, std::size_t k) const {
    return {u_[3 * triangle + k], v_[3 * triangle + k]};
  }
  /// Barycentric weights λ_k of p: Σ λ_k p_k = p, Σ λ_k = 1.
  Weights weights(std::size_t triangle, const Place& p) const {
    const Place a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const double l1 = ((p[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (p[1] - a[1])) / twice;
    const double l2 = ((b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1])) / twice;
    return {1 - l1 - l2, l1, l2};
  }
  /// Returns the first triangle that contains the place, or else the nearest one.
  std::size_t triangle_at(const Place& p) const {
    for (const std::uint32_t t : cells_[cell(p)])
      if (depth(t, p) >= 0) return t;
    std::size_t best = 0;
    for (std::size_t t = 1; t < triangles(); ++t)
      if (depth(t, p) > depth(best, p)) best = t;
    return best;
  }
  std::uint32_t node(std::size_t triangle, std::size_t k) const { return part_.nodes[3 * triangle + k]; }

  /// Fills the grid of cells that triangle_at() needs for its search.
  void make_grid() {
    for (const std::size_t k : {0u, 1u}) {
      const auto [low, high] = std::minmax_element((k ? v_ : u_).begin(), (k ? v_ : u_).end());
      low_[k] = *low;
      side_[k] = std::max(*high - *low, std::numeric_limits<double>::min());
    }
    count_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles()))) + 1;
    cells_.assign(count_ * count_, {});
    for (std::size_t t = 0; t < triangles(); ++t) list(t);
  }

 private:
  double depth(std::size_t t, const Place& p) const {
    const Weights w = weights(t, p);
    return std::min({w[0], w[1], w[2]});
  }
  std::size_t index(double x, std::size_t k) const {
    const double at = (x - low_[k]) / side_[k] * static_cast<double>(count_);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count_ - 1)));
  }
  std::size_t cell(const Place& p) const { return index(p[0], 0) * count_ + index(p[1], 1); }
  void list(std::size_t t) {
    Place low = corner(t, 0), high = low;
    for (std::size_t c = 1; c < 3; ++c)
      for (const std::size_t k : {0u, 1u}) {
        low[k] = std::min(low[k], corner(t, c)[k]);
        high[k] = std::max(high[k], corner(t, c)[k]);
      }
    for (std::size_t i = index(low[0], 0); i <= index(high[0], 0); ++i)
      for (std::size_t j = index(low[1], 1); j <= index(high[1], 1); ++j)
        cells_[i * count_ + j].push_back(static_cast<std::uint32_t>(t));
  }

  const Part& part_;
  const std::vector<double>&u_, &v_;
  Place low_{}, side_{};
  std::size_t count_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;  // triangles whose bounding box touches each cell
};

std::size_t at(std::uint32_t node) { return 3 * std::size_t{node}; }

/// The distance of each node from the start of the rope, as a fraction of the unstretched length.
std::vector<double> shares_of(const Part& rope) {
  std::vector<double> shares{0};
  for (const double length : rope.data.at(datum::kRestLength.name)) shares.push_back(shares.back() + length);
  for (double& share : shares) share /= shares.back();
  return shares;
}

/// The nodes of a rope from start to end.
std::vector<std::uint32_t> row_of(const Part& rope) {
  std::vector<std::uint32_t> row;
  for (std::size_t i = 0; i < rope.nodes.size(); i += 2) row.push_back(rope.nodes[i]);
  if (!rope.nodes.empty()) row.push_back(rope.nodes.back());
  return row;
}

}  // namespace

void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions) {
  Netting source(from);
  const Netting target(to);
  source.make_grid();
  for (std::size_t t = 0; t < target.triangles(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place place = target.corner(t, k);
      const std::size_t there = source.triangle_at(place);
      const Weights w = source.weights(there, place);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += w[c] * x[at(source.node(there, c)) + axis];
        positions[at(target.node(t, k)) + axis] = sum;
      }
    }
}

void carry_rope(const Part& from, const std::vector<double>& x, const Part& to,
                std::vector<double>& positions) {
  const auto shares = shares_of(from), own = shares_of(to);
  const auto row = row_of(from), nodes = row_of(to);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto next = std::upper_bound(shares.begin() + 1, shares.end() - 1, own[i]);
    const auto b = static_cast<std::size_t>(next - shares.begin());
    const double t = (own[i] - shares[b - 1]) / (shares[b] - shares[b - 1]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      positions[at(nodes[i]) + axis] = (1 - t) * x[at(row[b - 1]) + axis] + t * x[at(row[b]) + axis];
  }
}

}  // namespace netloft::runs
