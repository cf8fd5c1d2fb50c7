// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/holder.hpp"

#include "io/scenes/reading/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft::scenes {

namespace {

std::uint8_t read_axes(formats::TableReader& table) {
  const int before = table.diagnostics().errors();
  const std::string text =
      table.text("axes", {.doc = "axes along which nodes cannot move: letters of xyz", .fallback = "xyz"});
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

/// Reads `along`, the direction of a line along which the nodes are free, or `plane`, the normal of a plane
/// in which the nodes are free (a plane of symmetry).
void read_frame(formats::TableReader& table, HoldEntry& entry) {
  const bool along = table.has("along"), plane = table.has("plane");
  if (!along && !plane) return;
  if (along + plane + table.has("axes") > 1)
    table.error(along ? "along" : "plane",
                "cannot be combined with the other ways to hold: give only one of along, plane and axes");
  if (table.has("at"))
    table.error(
        "at", "cannot be combined with along or plane, which pass through the nodes where they are sketched",
        "sketch the part where the line or plane is");
  const auto d = along ? table.reals("along", {.doc = "direction of the line on which the nodes slide",
                                               .range = formats::between(-1e6, 1e6),
                                               .count = formats::exactly(3)})
                       : table.reals("plane", {.doc = "normal of the plane in which the nodes stay",
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
    table.choice("at", {.allowed = {"sketch"}, .doc = "the word sketch, or points where it is held"});
    return;
  }
  const formats::Range range = formats::between(-1e6, 1e6);
  const formats::Value* said = table.raw("at");
  const formats::Table* with_unit = said->as<formats::Table>();
  if (with_unit && with_unit->find("values")) said = &with_unit->find("values")->value;
  const formats::Array* array = said->as<formats::Array>();
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

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Whether two lengths, or two speeds, are equal up to round-off.
bool is_one(double a, double b) { return std::abs(a - b) <= 1e-9 * (1 + std::abs(a)); }

/// The unit vector along an axis of a frame, or of the world if the frame is nullptr.
Point axis_of(const std::array<double, 9>* frame, std::size_t axis) {
  if (frame) return {(*frame)[axis], (*frame)[3 + axis], (*frame)[6 + axis]};
  Point unit{};
  unit[axis] = 1;
  return unit;
}

std::vector<Point> axes_of(const std::array<double, 9>* frame, int axes) {
  std::vector<Point> all;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (axes & (1 << axis)) all.push_back(axis_of(frame, axis));
  return all;
}

const char* const kCureOfPlaces =
    "give both the same place (without `at` a hold is where the sketch has it), or leave the node out of one "
    "of them";
const char* const kCureOfMotions =
    "give both the same motion, leave the node out of one of them, or hold it there along other axes";

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
  entry.is_loose = table.boolean(
      "loose", {.doc = "true: the hold only keeps the gear from drifting, and bears no force in equilibrium",
                .fallback = false});
  entry.name =
      table.text("name", {.doc = "name of the reaction", .fallback = entry.on.empty() ? "" : entry.on[0]});
  return entry;
}

/// The constructor keeps the motion of nodes that a ship of the net plan moves.
Holder::Holder(Scene& scene) : scene_(scene), sketch_(scene.positions) {
  for (const Guide& guide : scene.guides) {
    const auto grip = std::make_shared<const Grip>(Grip{{}, guide.course});
    for (std::size_t i = 0; i < guide.nodes.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (guide.axes[i] & (1 << axis)) grips_[guide.nodes[i]][axis] = grip;
  }
}

Hold Holder::hold(const HoldEntry& entry, const std::vector<std::uint32_t>& nodes,
                  formats::TableReader& table) {
  if (is_one_point(entry.at) && nodes.size() > 1 && entry.axes == kAllAxes)
    table.error("at", std::to_string(nodes.size()) + " nodes cannot be held in one point",
                "give two or more points of a line, along which they are spread");
  const auto grip =
      std::make_shared<const Grip>(Grip{table.place(table.has("at") ? "at" : "on"), entry.course});
  bool all_agree = true;
  Hold held{entry.name, nodes, {}, entry.is_loose};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!can_hold(nodes[i], entry)) {
      table.error("on", "a node of \"" + entry.name + "\" is held in another way already",
                  "hold it in one place, or leave it out of one of the sets");
      return held;
    }
    const Point at = place(entry, i, nodes);
    all_agree = all_agree && agrees(nodes[i], entry, at, table);
    held.axes.push_back(static_cast<std::uint8_t>(entry.axes & ~scene_.held[nodes[i]]));
    if (all_agree) put(nodes[i], entry, at, grip);
  }
  return held;
}

/// The position that an entry gives a node: a point of `at`, or the initial position if `at` is empty.
Point Holder::place(const HoldEntry& entry, std::size_t i, const std::vector<std::uint32_t>& nodes) const {
  if (!entry.at.empty())
    return along_line(entry.at, nodes.size() > 1 ? double(i) / double(nodes.size() - 1) : 0);
  const double* x = &sketch_[3 * std::size_t{nodes[i]}];
  return {x[0], x[1], x[2]};
}

/// The axes of a node to which its bits in `held` refer; nullptr for the axes of the world.
const std::array<double, 9>* Holder::frame_of(std::uint32_t node) const {
  const auto at = scene_.frames.find(node);
  return at == scene_.frames.end() ? nullptr : &at->second;
}

Point Holder::position(std::uint32_t node) const {
  const double* x = &scene_.positions[3 * std::size_t{node}];
  return {x[0], x[1], x[2]};
}

/// Whether an entry can hold a node that earlier entries may already hold. It cannot if it and the earlier
/// entries use different frames, and neither they nor it hold all three axes.
bool Holder::can_hold(std::uint32_t node, const HoldEntry& entry) const {
  if (scene_.held[node] == 0 || scene_.held[node] == kAllAxes || entry.axes == kAllAxes) return true;
  const auto* own = frame_of(node);
  return entry.frame ? own && *own == *entry.frame : !own;
}

/// The directions along which both `entry` and earlier entries hold a node. can_hold() must be true for this
/// node.
std::vector<Point> Holder::shared_directions(std::uint32_t node, const HoldEntry& entry) const {
  const auto* frame = entry.frame ? &*entry.frame : nullptr;
  if (scene_.held[node] == kAllAxes) return axes_of(frame, entry.axes);
  return axes_of(frame_of(node), scene_.held[node] & entry.axes);
}

/// Whether an entry gives a node the same place and the same motion as earlier entries. If not, reports an
/// error that states the difference.
bool Holder::agrees(std::uint32_t node, const HoldEntry& entry, const Point& at,
                    formats::TableReader& table) const {
  const Point now = position(node);
  for (const Point& direction : shared_directions(node, entry)) {
    const bool is_there = is_one(dot(direction, at), dot(direction, now));
    if (is_there && moves_alike(node, entry.course, direction)) continue;
    const std::string name = scene_.node_name(node),
                      by = " by " + holder_of(node, direction, table.diagnostics());
    if (!is_there)
      table.error(table.has("at") ? "at" : "on",
                  name + " is held " + (entry.frame ? "through " : "at ") + spell(at) + " here and at " +
                      spell(now) + by,
                  kCureOfPlaces);
    else if (entry.course.knots.empty())
      table.error("on", name + " is not moved here, but is moved" + by, kCureOfMotions);
    else
      table.error(table.has("velocity") ? "velocity" : "displacement",
                  name + " is moved here, but " +
                      (moves_alike(node, {}, direction) ? "not moved" : "moved differently") + by,
                  kCureOfMotions);
    return false;
  }
  return true;
}

/// Whether earlier entries move a node along `direction` in the same way as `course`. A course is cubic
/// between its knots; therefore two courses are equal if they agree at the knots of both.
bool Holder::moves_alike(std::uint32_t node, const Course& course, const Point& direction) const {
  std::vector<std::pair<Point, const Course*>> parts;  // an axis of the node, times its component along the
                                                       // direction
  if (const auto grips = grips_.find(node); grips != grips_.end())
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto& grip = grips->second[k]) {
        const Point axis = axis_of(frame_of(node), k);
        const double share = dot(axis, direction);
        if (share != 0) parts.push_back({{share * axis[0], share * axis[1], share * axis[2]}, &grip->course});
      }
  std::vector<double> times;
  for (const auto& knot : course.knots) times.push_back(knot.t);
  for (const auto& part : parts)
    for (const auto& knot : part.second->knots) times.push_back(knot.t);
  return std::ranges::all_of(times, [&](double t) {
    const Course::Moment mine = course.at(t);
    double d = 0, v = 0;
    for (const auto& [along, theirs] : parts) {
      const Course::Moment moment = theirs->at(t);
      d += dot(along, moment.d);
      v += dot(along, moment.v);
    }
    return is_one(dot(direction, mine.d), d) && is_one(dot(direction, mine.v), v);
  });
}

/// The file and line of the entry that holds the node along the axis nearest to `direction`.
std::string Holder::holder_of(std::uint32_t node, const Point& direction,
                              formats::Diagnostics& diagnostics) const {
  const Grip* nearest = nullptr;
  double most = 0;
  if (const auto grips = grips_.find(node); grips != grips_.end())
    for (std::size_t k = 0; k < 3; ++k)
      if (const double share = std::abs(dot(axis_of(frame_of(node), k), direction));
          grips->second[k] && share > most) {
        most = share;
        nearest = grips->second[k].get();
      }
  return nearest && nearest->said_at ? diagnostics.where(*nearest->said_at) : "the net plan";
}

/// Holds a node along those axes of an entry that are still free. If these axes are along a line or normal to
/// a plane, the initial position does not change.
void Holder::put(std::uint32_t node, const HoldEntry& entry, const Point& at,
                 const std::shared_ptr<const Grip>& grip) {
  std::uint8_t& held = scene_.held[node];
  if (entry.frame && held != kAllAxes) scene_.frames[node] = *entry.frame;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(entry.axes & (1 << axis))) continue;
    if (!entry.frame) scene_.positions[3 * std::size_t{node} + axis] = at[axis];
    if (!(held & (1 << axis))) grips_[node][axis] = grip;
  }
  held |= entry.axes;
}

}  // namespace netloft::scenes
