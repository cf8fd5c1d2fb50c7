// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/holder.hpp"

#include "io/scenes/reading/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes {

namespace {

std::uint8_t read_axes(formats::TableReader& table) {
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
    if (axes & (1 << (c - 'x'))) table.error("axes", std::string("names ") + c + " twice");
    axes = static_cast<std::uint8_t>(axes | (1 << (c - 'x')));
  }
  if (!axes) table.error("axes", "holds nothing", "leave the key out to hold all of x, y and z");
  return axes ? axes : std::uint8_t{kAllAxes};
}

/// A rotation matrix whose first column is the direction of `d`.
std::array<double, 9> frame_along(const std::array<double, 3>& d) {
  const double length = std::hypot(d[0], d[1], d[2]);
  const std::array<double, 3> a{d[0] / length, d[1] / length, d[2] / length};
  std::array<double, 3> b =
      std::abs(a[2]) < 0.9 ? std::array<double, 3>{-a[1], a[0], 0} : std::array<double, 3>{0, -a[2], a[1]};
  const double width = std::hypot(b[0], b[1], b[2]);
  for (double& v : b) v /= width;
  const std::array<double, 3> c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                a[0] * b[1] - a[1] * b[0]};
  return {a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]};
}

/// Reads `along`, the direction of a line on which the nodes can move, or `plane`, the normal of a plane in
/// which they can move (a plane of symmetry).
void read_frame(formats::TableReader& table, HoldEntry& entry) {
  const bool along = table.has("along"), plane = table.has("plane");
  if (!along && !plane) return;
  if (along + plane + table.has("axes") > 1)
    table.error(along ? "along" : "plane", "is one way to hold; along, plane and axes exclude each other");
  if (table.has("at"))
    table.error("at",
                "does not go with along and plane, which pass through the nodes where they are sketched",
                "sketch the part where the line or plane is");
  const auto d = along ? table.reals("along", {.doc = "direction of the line it slides on",
                                               .range = formats::between(-1e6, 1e6),
                                               .count = formats::exactly(3)})
                       : table.reals("plane", {.doc = "normal of the plane it stays in",
                                               .range = formats::between(-1e6, 1e6),
                                               .count = formats::exactly(3)});
  if (d.size() != 3) return;
  if (std::hypot(d[0], d[1], d[2]) == 0) {
    table.error(along ? "along" : "plane", "has no direction");
    return;
  }
  entry.frame = frame_along({d[0], d[1], d[2]});
  entry.axes = along ? kAxisY | kAxisZ : kAxisX;
}

void read_at(formats::TableReader& table, HoldEntry& entry) {
  const auto kind = table.kind("at");
  if (!kind) return;
  if (*kind == formats::Kind::text) {
    table.choice("at", {.allowed = {"sketch"}, .doc = "where the sketch has it, or points"});
    return;
  }
  const formats::Range range = formats::between(-1e6, 1e6);
  const formats::Array* array = table.raw("at")->as<formats::Array>();
  std::vector<std::vector<double>> rows;
  if (array && !array->items.empty() && array->items[0].kind() != formats::Kind::array)
    rows = {table.reals(
        "at", {.unit = "m", .doc = "point where it is held", .range = range, .count = formats::exactly(3)})};
  else
    rows = table.rows("at", {.unit = "m",
                             .doc = "points of the line along which it is held",
                             .range = range,
                             .rows = {.least = 1},
                             .columns = formats::exactly(3)});
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

/// Whether two points agree, up to round-off, along the axes that both entries hold.
bool agree(const std::array<double, 3>& a, const std::array<double, 3>& b, int axes) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((axes & (1 << axis)) && std::abs(a[axis] - b[axis]) > 1e-9 * (1 + std::abs(a[axis]))) return false;
  return true;
}

}  // namespace

HoldEntry read_hold(formats::TableReader& table) {
  HoldEntry entry;
  const char* doc = "what is held: a part, an edge or a point (net.fore), or an array of them";
  if (table.kind("on") == formats::Kind::array)
    entry.on = table.texts("on", {.doc = doc, .count = {.least = 1}});
  else
    entry.on = {table.text("on", {.doc = doc})};
  entry.axes = read_axes(table);
  read_frame(table, entry);
  read_at(table, entry);
  entry.name =
      table.text("name", {.doc = "name of the reaction", .fallback = entry.on.empty() ? "" : entry.on[0]});
  return entry;
}

Hold Holder::hold(const HoldEntry& entry, const std::vector<std::uint32_t>& nodes,
                  formats::TableReader& table) {
  if (is_one_point(entry.at) && nodes.size() > 1 && entry.axes == kAllAxes)
    table.error("at", std::to_string(nodes.size()) + " nodes cannot be held in one point",
                "give two or more points of a line, along which they are spread");
  const auto points = places(entry, nodes);
  const char* said_by = table.has("at") ? "at" : "on";
  bool is_told = false;
  Hold held{entry.name, nodes, {}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!points.empty() && !is_told)
      is_told = !put(nodes[i], {points[i], entry.axes, table.place(said_by)}, table);
    if (entry.frame ? !turn(nodes[i], *entry.frame) : !holds_along_world_axes(nodes[i], entry.axes)) {
      table.error("on", "a node of \"" + entry.name + "\" is held in another way already",
                  "hold it in one place, or leave it out of one of the sets");
      return held;
    }
    held.axes.push_back(static_cast<std::uint8_t>(entry.axes & ~scene_.held[nodes[i]]));
    scene_.held[nodes[i]] |= entry.axes;
  }
  return held;
}

/// Whether a node can be held along axes of the world. If it has axes of its own, the bits of `held` refer to
/// these, and mean the same for the world only if all three are set.
bool Holder::holds_along_world_axes(std::uint32_t node, std::uint8_t axes) const {
  return axes == kAllAxes || scene_.held[node] == kAllAxes || !scene_.frames.contains(node);
}

/// Gives a node the axes of `frame`. Returns false if it is held along other axes already. A node that is
/// held along all axes keeps the axes of the world.
bool Holder::turn(std::uint32_t node, const std::array<double, 9>& frame) {
  if (scene_.held[node] == kAllAxes) return true;
  if (const auto at = scene_.frames.find(node); at != scene_.frames.end()) return at->second == frame;
  if (scene_.held[node]) return false;
  scene_.frames[node] = frame;
  return true;
}

/// The held position of every node: the initial one, unless the entry gives other places. Empty for an entry
/// with `along` or `plane`, whose axes are not those of the world.
std::vector<Holder::Point> Holder::places(const HoldEntry& entry,
                                          const std::vector<std::uint32_t>& nodes) const {
  std::vector<Point> points;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double* x = &sketch_[3 * std::size_t{nodes[i]}];
    if (entry.at.empty() && !entry.frame) points.push_back({x[0], x[1], x[2]});
    if (!entry.at.empty())
      points.push_back(along_line(entry.at, nodes.size() > 1 ? double(i) / double(nodes.size() - 1) : 0));
  }
  return points;
}

/// Puts a node at its held position. If another entry holds it elsewhere, reports this and returns false.
bool Holder::put(std::uint32_t node, const Put& put, formats::TableReader& table) {
  for (const Put& earlier : put_[node])
    if (!agree(put.point, earlier.point, put.axes & earlier.axes)) {
      table.error(table.has("at") ? "at" : "on",
                  scene_.node_name(node) + " is held at " + spell(put.point) + " here and at " +
                      spell(earlier.point) + " by " + table.diagnostics().where(earlier.said_at),
                  "give both the same place (without `at` a hold is where the sketch has it), or leave the "
                  "node out of one of them");
      return false;
    }
  put_[node].push_back(put);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (put.axes & (1 << axis)) scene_.positions[3 * std::size_t{node} + axis] = put.point[axis];
  return true;
}

}  // namespace netloft::scenes
