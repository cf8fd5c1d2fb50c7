// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/geometry.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace netloft::io {

namespace {

constexpr std::int64_t kMostCells = 100000;      // along one direction
constexpr std::int64_t kMostElements = 4000000;  // of one part

using Point = std::array<double, 3>;

std::vector<Point> read_sketch(TableReader& part, Count points, const std::string& doc) {
  std::vector<Point> sketch;
  const auto rows = part.rows(
      "sketch",
      {.unit = "m", .doc = doc, .range = between(-1e6, 1e6), .rows = points, .columns = exactly(3)});
  for (const auto& row : rows)
    if (row.size() == 3) sketch.push_back({row[0], row[1], row[2]});
  return sketch;
}

double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

Point between_points(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// The point a share t of the way along a line.
Point along_line(const std::vector<Point>& line, double t) {
  double total = 0;
  for (std::size_t i = 1; i < line.size(); ++i) total += distance(line[i - 1], line[i]);
  double left = t * total;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double leg = distance(line[i - 1], line[i]);
    if (left <= leg && leg > 0) return between_points(line[i - 1], line[i], left / leg);
    left -= leg;
  }
  return line.back();
}

void append(std::vector<double>& positions, const Point& p) {
  positions.insert(positions.end(), p.begin(), p.end());
}

/// Rows and columns of a structured panel.
struct Grid {
  std::size_t across, along;
  std::size_t columns() const { return across + 1; }
  std::uint32_t node(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(j * columns() + i);
  }
};

void name_edges(const Grid& g, PartGeometry& names) {
  for (std::size_t i = 0; i <= g.across; ++i) {
    names.sets["fore"].push_back(g.node(i, 0));
    names.sets["aft"].push_back(g.node(i, g.along));
  }
  for (std::size_t j = 0; j <= g.along; ++j) {
    names.sets["left"].push_back(g.node(0, j));
    names.sets["right"].push_back(g.node(g.across, j));
  }
  names.sets["fore-left"] = {g.node(0, 0)};
  names.sets["fore-right"] = {g.node(g.across, 0)};
  names.sets["aft-left"] = {g.node(0, g.along)};
  names.sets["aft-right"] = {g.node(g.across, g.along)};
}

/// Nodes of the panel on the bilinear surface through the four corners.
void place_nodes(const Grid& g, const std::vector<Point>& corner, double meshes_across, double meshes_along,
                 Geometry& out) {
  for (std::size_t j = 0; j <= g.along; ++j)
    for (std::size_t i = 0; i <= g.across; ++i) {
      const double s = double(i) / double(g.across), t = double(j) / double(g.along);
      append(out.positions, between_points(between_points(corner[0], corner[1], s),
                                           between_points(corner[3], corner[2], s), t));
      out.names.panel.push_back({meshes_across * s, meshes_along * t});
    }
}

void add_triangle(const Grid& g, std::array<std::array<std::size_t, 2>, 3> corners, double bar,
                  Geometry& out) {
  for (const auto& [i, j] : corners) {
    const std::uint32_t node = g.node(i, j);
    const auto [U, V] = out.names.panel[node];
    out.elements.push_back(node);
    out.data["u"].push_back(U + V);
    out.data["v"].push_back(V - U);
  }
  out.data["bar_length"].push_back(bar);
}

}  // namespace

Geometry read_line(TableReader& part) {
  Geometry out;
  const double length = part.real(
      "length",
      {.unit = "m", .doc = "unstretched length of the rope", .range = {.lo = 0, .hi = 1e6, .lo_open = true}});
  const auto cells =
      part.integer("cells", {.doc = "bars the rope is divided into", .lo = 1, .hi = kMostCells});
  const auto sketch = read_sketch(part, {.least = 2}, "points of the line along which the rope starts");
  if (sketch.size() < 2 || cells < 1) return out;
  const auto n = static_cast<std::uint32_t>(cells);
  for (std::uint32_t i = 0; i <= n; ++i) append(out.positions, along_line(sketch, double(i) / n));
  for (std::uint32_t i = 0; i < n; ++i) out.elements.insert(out.elements.end(), {i, i + 1});
  out.data["rest_length"].assign(n, length / n);
  out.names.sets["start"] = {0};
  out.names.sets["end"] = {n};
  if (n % 2 == 0) out.names.sets["middle"] = {n / 2};
  return out;
}

Geometry read_panel(TableReader& part) {
  Geometry out;
  TableReader panel = part.table("panel", Presence::required, "size of the panel in meshes");
  const Range meshes{.lo = 0, .hi = 1e6, .lo_open = true};
  const double across = panel.real("across", {.doc = "meshes across the panel", .range = meshes});
  const double along = panel.real("along", {.doc = "meshes along the panel", .range = meshes});
  const double bar = panel.real("bar", {.unit = "m",
                                        .doc = "unstretched bar, from knot to knot: half the mesh size",
                                        .range = {.lo = 0, .hi = 100, .lo_open = true}});
  const auto cells = part.integers(
      "cells",
      {.doc = "cells across and along, two triangles each", .lo = 1, .hi = kMostCells, .count = exactly(2)});
  const auto sketch = read_sketch(part, exactly(4), "corners: fore left, fore right, aft right, aft left");
  if (cells.size() != 2 || sketch.size() != 4) return out;
  if (cells[0] * cells[1] * 2 > kMostElements) {
    part.error("cells", "makes " + std::to_string(cells[0] * cells[1] * 2) + " triangles; at most " +
                            std::to_string(kMostElements) + " are taken in one part");
    return out;
  }
  const Grid g{static_cast<std::size_t>(cells[0]), static_cast<std::size_t>(cells[1])};
  place_nodes(g, sketch, across, along, out);
  name_edges(g, out.names);
  for (std::size_t j = 0; j < g.along; ++j)
    for (std::size_t i = 0; i < g.across; ++i)
      if ((i + j) % 2 == 0) {
        add_triangle(g, {{{i, j}, {i + 1, j}, {i + 1, j + 1}}}, bar, out);
        add_triangle(g, {{{i, j}, {i + 1, j + 1}, {i, j + 1}}}, bar, out);
      } else {
        add_triangle(g, {{{i, j}, {i + 1, j}, {i, j + 1}}}, bar, out);
        add_triangle(g, {{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}}, bar, out);
      }
  return out;
}

}  // namespace netloft::io
