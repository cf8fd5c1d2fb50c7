// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/coarser.hpp"

#include "io/runs/carried_gear.hpp"

#include <algorithm>
#include <array>

namespace netloft::runs {

namespace {

using Point = std::array<double, 3>;
constexpr int kFewestAcross = 4, kFewestBars = 4;

bool is_divided(const scenes::PartGeometry& part) { return !part.cells.empty(); }

int half_of(int cells) { return (cells + 1) / 2; }

/// Whether the cells of a part can be halved: the part must have enough cells, and nothing may name one of
/// its nodes by number.
bool can_halve(const scenes::PartGeometry& part, Halved which) {
  if (part.is_numbered) return false;
  const int fewest = part.cells.size() == 1 ? kFewestBars : kFewestAcross;
  return std::all_of(part.cells.begin(), part.cells.end(), [&](int cells) {
    return half_of(cells) >= fewest && (which == Halved::all || cells % 2 == 0);
  });
}

formats::Change halve(const scenes::PartGeometry& part) {
  formats::Array cells;
  for (const int n : part.cells) cells.items.push_back({{}, std::int64_t{half_of(n)}});
  return formats::make_change({"parts", part.name, "cells"},
                              part.cells.size() == 1 ? cells.items[0] : formats::Value{{}, cells});
}

/// Number of nodes at corners of the cells of a part. The nodes in the middles of cells have higher numbers.
std::size_t corners_of(const scenes::PartGeometry& part) {
  std::size_t nodes = 1;
  for (const int cells : part.cells) nodes *= static_cast<std::size_t>(cells) + 1;
  return nodes;
}

std::size_t middles_of(const scenes::PartGeometry& part) {
  if (part.cells.size() != 2) return 0;
  return static_cast<std::size_t>(part.cells[0]) * static_cast<std::size_t>(part.cells[1]);
}

bool has_middles(const scenes::PartGeometry& part) {
  return middles_of(part) > 0 && part.nodes.size() == corners_of(part) + middles_of(part);
}

/// The shape of a part in a scene with the node positions x [m]. From this shape, nodes of another division
/// of the part get their positions.
class Shape {
 public:
  Shape(const scenes::PartGeometry& part, const std::vector<double>& x) : part_(part), x_(x) {}

  Point node(std::size_t own) const {
    const std::size_t at = 3 * std::size_t{part_.nodes[own]};
    return {x_[at], x_[at + 1], x_[at + 2]};
  }
  /// The position at fraction s of a rope.
  Point on_rope(double s) const {
    const auto [cell, t] = locate(s, part_.cells[0]);
    return mix({{{cell, 1 - t}, {cell + 1, t}, {cell, 0.0}}});
  }
  /// The position at fractions s across and t along a panel, interpolated in the triangle that contains it.
  Point on_panel(double s, double t) const {
    const auto [i, a] = locate(s, part_.cells[0]);
    const auto [j, b] = locate(t, part_.cells[1]);
    return has_middles(part_) ? in_crossed_cell(i, j, a, b) : in_cell(i, j, a, b);
  }

 private:
  struct Weight {
    std::size_t own;
    double weight;
  };
  std::size_t corner(std::size_t i, std::size_t j) const {
    return j * (static_cast<std::size_t>(part_.cells[0]) + 1) + i;
  }
  /// Interpolates in a cell of two triangles, whose diagonal alternates from cell to cell.
  Point in_cell(std::size_t i, std::size_t j, double a, double b) const {
    const auto p00 = corner(i, j), p10 = corner(i + 1, j), p01 = corner(i, j + 1), p11 = corner(i + 1, j + 1);
    if ((i + j) % 2 == 0)
      return a >= b ? mix({{{p00, 1 - a}, {p10, a - b}, {p11, b}}})
                    : mix({{{p00, 1 - b}, {p01, b - a}, {p11, a}}});
    return a + b <= 1 ? mix({{{p00, 1 - a - b}, {p10, a}, {p01, b}}})
                      : mix({{{p11, a + b - 1}, {p10, 1 - b}, {p01, 1 - a}}});
  }
  /// Interpolates in a cell of four triangles around its middle node.
  Point in_crossed_cell(std::size_t i, std::size_t j, double a, double b) const {
    const auto p00 = corner(i, j), p10 = corner(i + 1, j), p01 = corner(i, j + 1), p11 = corner(i + 1, j + 1);
    const auto middle = corners_of(part_) + j * static_cast<std::size_t>(part_.cells[0]) + i;
    if (b <= a && a + b <= 1) return mix({{{p00, 1 - a - b}, {p10, a - b}, {middle, 2 * b}}});
    if (b >= a && a + b >= 1) return mix({{{p01, b - a}, {p11, a + b - 1}, {middle, 2 * (1 - b)}}});
    if (b >= a) return mix({{{p00, 1 - a - b}, {p01, b - a}, {middle, 2 * a}}});
    return mix({{{p10, a - b}, {p11, a + b - 1}, {middle, 2 * (1 - a)}}});
  }
  static std::pair<std::size_t, double> locate(double share, int cells) {
    const double at = share * cells;
    const auto cell = static_cast<std::size_t>(std::clamp(static_cast<int>(at), 0, cells - 1));
    return {cell, at - static_cast<double>(cell)};
  }
  Point mix(const std::array<Weight, 3>& weights) const {
    Point sum{};
    for (const auto& [own, weight] : weights)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight == 0 ? 0 : weight * node(own)[k];
    return sum;
  }

  const scenes::PartGeometry& part_;
  const std::vector<double>& x_;
};

bool is_structured(const scenes::PartGeometry& part) {
  return part.nodes.size() == corners_of(part) || has_middles(part);
}

/// The place of node `own` of the part: its fraction along a rope, or its fractions across and along a panel.
std::array<double, 2> shares_of(const scenes::PartGeometry& part, std::size_t own) {
  if (part.cells.size() == 1) return {static_cast<double>(own) / part.cells[0], 0};
  const bool is_middle = own >= corners_of(part);
  const auto columns = static_cast<std::size_t>(part.cells[0]) + (is_middle ? 0 : 1);
  const std::size_t at = is_middle ? own - corners_of(part) : own;
  const double half = is_middle ? 0.5 : 0;
  return {(static_cast<double>(at % columns) + half) / part.cells[0],
          (static_cast<double>(at / columns) + half) / part.cells[1]};
}

}  // namespace

namespace {

constexpr std::size_t kFewestNodes = 120;  // a coarser gear has at least this many nodes

bool is_numbered(const scenes::GearInScene& gear, const std::vector<scenes::PartGeometry>& parts) {
  const auto numbered = [&](std::uint32_t p) { return parts[p].is_numbered; };
  return std::ranges::any_of(gear.panels, numbered) || std::ranges::any_of(gear.ropes, numbered);
}

/// Doubles the side of elements, so that a quarter of the nodes remains.
std::vector<formats::Change> coarser_gear(const scenes::GearInScene& gear, const scenes::LoadedScene& fine) {
  const std::size_t nodes = fine.scene.node_count();
  if (nodes / 4 < kFewestNodes || is_numbered(gear, fine.parts)) return {};
  if (gear.size > 0) return {formats::make_change({"gear", "size"}, {{}, 2 * gear.size})};
  return {formats::make_change({"gear", "nodes"}, {{}, static_cast<std::int64_t>(gear.nodes / 4)})};
}

/// Copies the positions of origins and points of rigid bodies, as far as both bodies have a point at the same
/// place: points on a rim are those of the mesh. Rotations are copied by VariantProblems::transfer.
void carry_bodies(const Scene& from, const std::vector<double>& x, const Scene& to,
                  std::vector<double>& positions) {
  const auto copy = [&](std::uint32_t source, std::uint32_t target) {
    std::copy_n(x.begin() + 3 * std::ptrdiff_t{source}, 3, positions.begin() + 3 * std::ptrdiff_t{target});
  };
  for (std::size_t b = 0; b < to.bodies.size(); ++b) {
    copy(from.bodies[b].origin, to.bodies[b].origin);
    for (const auto& point : to.bodies[b].points)
      if (const auto same = std::ranges::find(from.bodies[b].points, point.r, &RigidBody::Point::r);
          same != from.bodies[b].points.end())
        copy(same->node, point.node);
  }
}

void carry_gear(const scenes::LoadedScene& from, const std::vector<double>& x, const scenes::LoadedScene& to,
                std::vector<double>& positions) {
  for (const auto p : to.gear->ropes) carry_rope(from.scene.parts[p], x, to.scene.parts[p], positions);
  for (const auto p : to.gear->panels) carry_panel(from.scene.parts[p], x, to.scene.parts[p], positions);
}

}  // namespace

std::vector<formats::Change> halved_cells(const scenes::LoadedScene& fine, Halved which) {
  std::vector<formats::Change> changes;
  for (const auto& part : fine.parts)
    if (is_divided(part) && can_halve(part, which)) changes.push_back(halve(part));
  if (fine.gear) formats::append(changes, coarser_gear(*fine.gear, fine));
  return changes;
}

std::optional<std::vector<double>> carried_over(const scenes::LoadedScene& from, const std::vector<double>& x,
                                                const scenes::LoadedScene& to) {
  if (from.parts.size() != to.parts.size() || from.gear.has_value() != to.gear.has_value()) return {};
  if (from.scene.bodies.size() != to.scene.bodies.size()) return {};
  std::vector<double> positions = to.scene.positions;
  carry_bodies(from.scene, x, to.scene, positions);
  if (to.gear) carry_gear(from, x, to, positions);
  for (std::size_t p = 0; p < to.parts.size(); ++p) {
    const scenes::PartGeometry &source = from.parts[p], &part = to.parts[p];
    if (!is_divided(part)) continue;
    if (!is_structured(source) || !is_structured(part) || source.cells.size() != part.cells.size()) return {};
    const Shape shape(source, x);
    for (std::size_t own = 0; own < part.nodes.size(); ++own) {
      const auto [s, t] = shares_of(part, own);
      const Point at = part.cells.size() == 1 ? shape.on_rope(s) : shape.on_panel(s, t);
      std::copy(at.begin(), at.end(), positions.begin() + 3 * std::ptrdiff_t{part.nodes[own]});
    }
  }
  return positions;
}

}  // namespace netloft::runs
