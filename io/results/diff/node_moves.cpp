// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/node_moves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace netloft::results {

namespace {

using Position = std::array<double, 3>;
using Place = std::array<double, 2>;  // coordinates U, V [meshes]
// A place counts as inside a triangle if none of its barycentric coordinates is below minus this number.
constexpr double kInside = 1e-6;

Position position_of(const std::vector<double>& points, std::uint32_t node) {
  return {points[3 * node], points[3 * node + 1], points[3 * node + 2]};
}

/// Finds the position of a place on one panel. A grid of squares lists, for each square, the triangles that
/// touch it.
class PanelIndex {
 public:
  PanelIndex(const StoredShape& result, const std::vector<double>& points, std::uint32_t part)
      : mesh_(result.mesh), points_(points) {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (mesh_.cell_part[mesh_.triangle_cells[t]] == part && std::isfinite(mesh_.corners[t][0]))
        triangles_.push_back(t);
    for (const std::size_t t : triangles_)
      for (std::size_t k = 0; k < 6; ++k) {
        lo_[k % 2] = std::min(lo_[k % 2], mesh_.corners[t][k]);
        hi_[k % 2] = std::max(hi_[k % 2], mesh_.corners[t][k]);
      }
    side_ =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles_.size()))));
    for (const std::size_t t : triangles_) insert(t);
  }

  /// Returns the position [m] of a place on the panel; nullopt outside the panel.
  std::optional<Position> at(const Place& p) const {
    const auto found = squares_.find({column(p, 0), column(p, 1)});
    if (found == squares_.end()) return {};
    for (const std::size_t t : found->second)
      if (const auto position = within(t, p)) return position;
    return {};
  }

 private:
  std::size_t column(const Place& p, std::size_t axis) const {
    const double width = std::max(hi_[axis] - lo_[axis], 1e-9);
    const double at = (p[axis] - lo_[axis]) / width * static_cast<double>(side_);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(side_ - 1)));
  }
  Place corner(std::size_t t, std::size_t k) const {
    return {mesh_.corners[t][2 * k], mesh_.corners[t][2 * k + 1]};
  }

  void insert(std::size_t t) {
    std::array<std::array<std::size_t, 2>, 2> range{};  // first and last column along each axis
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::array<std::size_t, 3> at = {column(corner(t, 0), axis), column(corner(t, 1), axis),
                                             column(corner(t, 2), axis)};
      range[axis] = {*std::min_element(at.begin(), at.end()), *std::max_element(at.begin(), at.end())};
    }
    for (std::size_t i = range[0][0]; i <= range[0][1]; ++i)
      for (std::size_t j = range[1][0]; j <= range[1][1]; ++j) squares_[{i, j}].push_back(t);
  }

  std::optional<Position> within(std::size_t t, const Place& p) const {
    const Place a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const double l1 = ((p[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (p[1] - a[1])) / twice;
    const double l2 = ((b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1])) / twice;
    if (!(l1 >= -kInside && l2 >= -kInside && l1 + l2 <= 1 + kInside)) return {};
    Position sum{};
    const std::array<double, 3> weights = {1 - l1 - l2, l1, l2};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += weights[k] * points_[3 * mesh_.triangles[t][k] + axis];
    return sum;
  }

  const StoredMesh& mesh_;
  const std::vector<double>& points_;
  std::vector<std::size_t> triangles_;
  std::array<double, 2> lo_{1e300, 1e300}, hi_{-1e300, -1e300};
  std::size_t side_ = 1;
  std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> squares_;
};

std::vector<std::size_t> nodes_per_part(const StoredShape& result) {
  std::vector<std::size_t> count(result.parts.size());
  for (const auto part : result.mesh.node_part) ++count[part];
  return count;
}

/// Finds the largest move. The member functions are the steps, in the order of execution.
class MoveFinder {
 public:
  MoveFinder(const StoredShape& before, const StoredShape& after)
      : before_(before),
        after_(after),
        from_(before.points(before.times.size() - 1)),
        to_(after.points(after.times.size() - 1)) {}

  std::optional<NodeMove> find() {
    const auto had = nodes_per_part(before_), has = nodes_per_part(after_);
    for (std::uint32_t part = 0; part < before_.parts.size(); ++part) {
      const auto other = find_part(after_, before_.parts[part].name);
      if (!other) continue;
      if (had[part] == has[*other])
        compare_by_number(part, *other);
      else
        compare_by_place(part, *other);
    }
    move_.compared = compared_.size();
    move_.nodes = before_.mesh.n_points;
    return compared_.empty() ? std::nullopt : std::optional(move_);
  }

 private:
  void compare_by_number(std::uint32_t part, std::uint32_t other) {
    std::map<std::uint32_t, std::uint32_t> node_of_number;
    for (std::uint32_t n = 0; n < after_.mesh.n_points; ++n)
      if (after_.mesh.node_part[n] == other) node_of_number[after_.mesh.node_number[n]] = n;
    for (std::uint32_t n = 0; n < before_.mesh.n_points; ++n) {
      if (before_.mesh.node_part[n] != part) continue;
      const auto found = node_of_number.find(before_.mesh.node_number[n]);
      if (found != node_of_number.end()) take(n, position_of(to_, found->second));
    }
  }

  void compare_by_place(std::uint32_t part, std::uint32_t other) {
    const PanelIndex panel(after_, to_, other);
    const StoredMesh& mesh = before_.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3 && mesh.cell_part[mesh.triangle_cells[t]] == part; ++k)
        if (mesh.node_part[mesh.triangles[t][k]] == part && std::isfinite(mesh.corners[t][0]))
          if (const auto at = panel.at({mesh.corners[t][2 * k], mesh.corners[t][2 * k + 1]}))
            take(mesh.triangles[t][k], *at);
  }

  void take(std::uint32_t node, const Position& after) {
    const Position before = position_of(from_, node);
    compared_[node] = true;
    const double distance = std::hypot(after[0] - before[0], after[1] - before[1], after[2] - before[2]);
    if (distance < move_.distance) return;
    move_.distance = distance;
    move_.before = before;
    move_.after = after;
    move_.part = before_.parts[before_.mesh.node_part[node]].name;
    move_.number = before_.mesh.node_number[node];
  }

  const StoredShape &before_, &after_;
  std::vector<double> from_, to_;
  std::map<std::uint32_t, bool> compared_;
  NodeMove move_;
};

}  // namespace

std::optional<NodeMove> find_largest_move(const StoredShape& before, const StoredShape& after) {
  return MoveFinder(before, after).find();
}

}  // namespace netloft::results
