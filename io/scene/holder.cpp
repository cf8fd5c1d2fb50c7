// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/holder.hpp"

#include "io/scene/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

std::uint8_t read_axes(TableReader& table) {
  const int before = table.diagnostics().errors();
  const std::string text =
      table.text("axes", {.doc = "along which it cannot move: letters of xyz", .fallback = "xyz"});
  if (table.diagnostics().errors() > before) return kAllAxes;
  std::uint8_t axes = 0;
  for (const char c : text) {
    if (c < 'x' || c > 'z') {
      table.error("axes", "\"" + text.substr(0, 20) + "\" is not made of the letters x, y and z");
      return kAllAxes;
    }
    axes = static_cast<std::uint8_t>(axes | (1 << (c - 'x')));
  }
  if (!axes) table.error("axes", "holds nothing", "leave the key out to hold all of x, y and z");
  return axes ? axes : std::uint8_t{kAllAxes};
}

void read_at(TableReader& table, HoldEntry& entry) {
  const auto kind = table.kind("at");
  if (!kind) return;
  if (*kind == Kind::text) {
    entry.as_sketched =
        table.choice("at", {.allowed = {"sketch"}, .doc = "where the sketch has it, or points"}) == "sketch";
    return;
  }
  const Range range = between(-1e6, 1e6);
  const Array* array = table.raw("at")->as<Array>();
  std::vector<std::vector<double>> rows;
  if (array && !array->items.empty() && array->items[0].kind() != Kind::array)
    rows = {table.reals("at",
                        {.unit = "m", .doc = "point where it is held", .range = range, .count = exactly(3)})};
  else
    rows = table.rows("at", {.unit = "m",
                             .doc = "points of the line along which it is held",
                             .range = range,
                             .rows = {.least = 1},
                             .columns = exactly(3)});
  for (const auto& row : rows)
    if (row.size() == 3) entry.at.push_back({row[0], row[1], row[2]});
}

bool is_one_point(const std::vector<std::array<double, 3>>& points) {
  return !points.empty() &&
         std::all_of(points.begin(), points.end(), [&](const auto& p) { return p == points[0]; });
}

std::string spell(const std::array<double, 3>& p) {
  const auto number = [](double v) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", v);
    return std::string(text);
  };
  return "(" + number(p[0]) + ", " + number(p[1]) + ", " + number(p[2]) + ") m";
}

/// The same place along the axes that both speak of, but for round-off.
bool agree(const std::array<double, 3>& a, const std::array<double, 3>& b, int axes) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((axes & (1 << axis)) && std::abs(a[axis] - b[axis]) > 1e-9 * (1 + std::abs(a[axis]))) return false;
  return true;
}

}  // namespace

HoldEntry read_hold(TableReader& table) {
  HoldEntry entry;
  entry.on = table.text("on", {.doc = "what is held: a part, an edge or a point (net.fore)"});
  entry.axes = read_axes(table);
  read_at(table, entry);
  entry.name = table.text("name", {.doc = "name of the reaction", .fallback = entry.on});
  return entry;
}

Hold Holder::hold(const HoldEntry& entry, const std::vector<std::uint32_t>& nodes, TableReader& table) {
  if (is_one_point(entry.at) && nodes.size() > 1 && entry.axes == kAllAxes)
    table.error("at", std::to_string(nodes.size()) + " nodes cannot be held in one point",
                "give two or more points of a line, along which they are spread");
  const auto points = places(entry, nodes);
  bool is_told = false;
  Hold held{entry.name, nodes, {}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!points.empty() && !is_told)
      is_told = !put(nodes[i], {points[i], entry.axes, table.place("at")}, table);
    held.axes.push_back(static_cast<std::uint8_t>(entry.axes & ~scene_.held[nodes[i]]));
    scene_.held[nodes[i]] |= entry.axes;
  }
  return held;
}

/// A point for every node; none at all if the entry leaves them where they are.
std::vector<Holder::Point> Holder::places(const HoldEntry& entry,
                                          const std::vector<std::uint32_t>& nodes) const {
  std::vector<Point> points;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double* x = &sketch_[3 * std::size_t{nodes[i]}];
    if (entry.as_sketched) points.push_back({x[0], x[1], x[2]});
    if (!entry.at.empty())
      points.push_back(along_line(entry.at, nodes.size() > 1 ? double(i) / double(nodes.size() - 1) : 0));
  }
  return points;
}

/// False: an error was put at `at`.
bool Holder::put(std::uint32_t node, const Put& put, TableReader& table) {
  for (const Put& earlier : put_[node])
    if (!agree(put.point, earlier.point, put.axes & earlier.axes)) {
      table.error("at",
                  scene_.node_name(node) + " is held at " + spell(put.point) + " here and at " +
                      spell(earlier.point) + " by " + table.diagnostics().where(earlier.said_at),
                  "let both say the same place, or leave the key out of one");
      return false;
    }
  put_[node].push_back(put);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (put.axes & (1 << axis)) scene_.positions[3 * std::size_t{node} + axis] = put.point[axis];
  return true;
}

}  // namespace netloft::io
