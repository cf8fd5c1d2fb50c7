// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/carried_gear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace netloft::io {

namespace {

using Place = std::array<double, 2>;    // (u, v) of netting
using Weights = std::array<double, 3>;  // of the corners of a triangle; they add up to one

/// The triangles of a panel in twine coordinates.
class Netting {
 public:
  explicit Netting(const Part& part) : part_(part), u_(part.data.at("u")), v_(part.data.at("v")) {}

  std::size_t triangles() const { return part_.nodes.size() / 3; }
  Place corner(std::size_t triangle, std::size_t k) const {
    return {u_[3 * triangle + k], v_[3 * triangle + k]};
  }
  /// λ_k with Σ λ_k p_k = p, Σ λ_k = 1.
  Weights weights(std::size_t triangle, const Place& p) const {
    const Place a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const double l1 = ((p[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (p[1] - a[1])) / twice;
    const double l2 = ((b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1])) / twice;
    return {1 - l1 - l2, l1, l2};
  }
  /// The triangle of which the place is least outside.
  std::size_t triangle_at(const Place& p) const {
    std::size_t best = 0;
    double depth = -std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < triangles() && depth < 0; ++t) {
      const Weights w = weights(t, p);
      if (const double least = std::min({w[0], w[1], w[2]}); least > depth) depth = least, best = t;
    }
    return best;
  }
  std::uint32_t node(std::size_t triangle, std::size_t k) const { return part_.nodes[3 * triangle + k]; }

 private:
  const Part& part_;
  const std::vector<double>&u_, &v_;
};

std::size_t at(std::uint32_t node) { return 3 * std::size_t{node}; }

/// Share of the way along a rope at the end of every bar, from zero.
std::vector<double> shares_of(const Part& rope) {
  std::vector<double> shares{0};
  for (const double length : rope.data.at("rest_length")) shares.push_back(shares.back() + length);
  for (double& share : shares) share /= shares.back();
  return shares;
}

/// Nodes from start to end.
std::vector<std::uint32_t> row_of(const Part& rope) {
  std::vector<std::uint32_t> row;
  for (std::size_t i = 0; i < rope.nodes.size(); i += 2) row.push_back(rope.nodes[i]);
  if (!rope.nodes.empty()) row.push_back(rope.nodes.back());
  return row;
}

}  // namespace

void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions) {
  const Netting source(from), target(to);
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

}  // namespace netloft::io
