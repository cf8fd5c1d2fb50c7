// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/read_bodies.hpp"

#include "io/formats/text/name_fault.hpp"
#include "io/scenes/reading/geometry_keys.hpp"
#include "io/scenes/reading/part_names.hpp"

#include <netloft/attitude.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace netloft::scenes {

namespace {

using Vector = Vec3<double>;

Point mirrored(const Point& r, double side) { return {r[0], side * r[1], r[2]}; }
Vector vector_of(const Point& p) { return {p[0], p[1], p[2]}; }
Point point_of(const Vector& v) { return {v.x, v.y, v.z}; }

/// The axis in a text such as "about y"; -1 if there is none.
int axis_in(const std::string& word) { return word.starts_with("about ") ? word.back() - 'x' : -1; }

void read_turning(formats::TableReader& table, BodyGeometry& body) {
  formats::TableReader turned = table.table("turned", formats::Presence::optional);
  const Attitude start{read_real(turned, kHeading, 0.0), read_real(turned, kHeel, 0.0),
                       read_real(turned, kTrim, 0.0)};
  body.rotation = point_of(rotation_vector(axes_of(start, body.side)));
  const std::string turns = read_word(table, kTurns);
  const int only = axis_in(turns);
  if (turns == "not") body.held_rotation = kAllAxes;
  if (only < 0) return;
  body.held_rotation = static_cast<std::uint8_t>(kAllAxes & ~(1 << only));
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (static_cast<int>(axis) != only && std::abs(body.rotation[axis]) > 1e-9) {
      table.error(
          "turns",
          "= " + formats::in_quotes(turns) + ", but `turned` turns the body about another axis at the start",
          "give in `turned` only a rotation about the axis of `turns`");
      return;
    }
}

void read_named_points(formats::TableReader& table, BodyGeometry& body) {
  formats::TableReader points =
      table.table("points", formats::Presence::optional, "points of the body by name");
  for (const auto& name : points.keys()) {
    const auto at = points.reals(
        name, {.unit = "m", .doc = kPoints.doc, .range = kPoints.range, .count = formats::exactly(3)});
    std::string fault = formats::name_fault(name);
    if (fault.empty() && name.find('.') != std::string::npos) fault = "must not contain a dot";
    if (fault.empty() && (name == "origin" || name.starts_with("node-")))
      fault = "is a name that every body has";
    if (!fault.empty()) points.error(name, "the name of a point, " + formats::in_quotes(name) + ", " + fault);
    if (at.size() != 3) continue;
    body.names.push_back(name);
    body.r.push_back(mirrored({at[0], at[1], at[2]}, body.side));
  }
}

std::optional<BodyRim> read_rim(formats::TableReader& table) {
  if (!table.has("rim")) return {};
  formats::TableReader rim = table.table("rim");
  BodyRim read{rim.text("edge", {.doc = kRimEdge.doc}), rim.place("edge"), {}, read_real(rim, kRimWidth), 0};
  read.height = read_real(rim, kRimHeight, read.width);
  if (rim.has("at")) read.at = read_one_point(rim, kRimAt);
  return read;
}

Point placed(const Point& origin, const Point& rotation, const Point& r) {
  return point_of(vector_of(origin) + rotated(vector_of(rotation), vector_of(r)));
}

/// The side of a body: 1 to starboard, -1 to port. For a body of a pair, the plan gives the side, and the
/// table of the body must not state one.
double read_side(formats::TableReader& table, const BodyOfPlan* plan) {
  if (!plan || table.has(kSide.name)) {
    const double said = read_word(table, kSide) == "port" ? -1 : 1;
    if (!plan) return said;
    table.error(kSide.name, "is given by the net plan, which has this body to starboard and to port",
                "leave side out; give the body stands = \"alone\" in the plan if there is only one");
  }
  return plan->side;
}

Point read_origin(formats::TableReader& table, const BodyOfPlan* plan, const BodyGeometry& body) {
  if (!plan) return read_one_point(table, kOrigin);
  if (table.has(kOrigin.name) || !plan->guess) return mirrored(read_one_point(table, kOrigin), body.side);
  double lowest = 0;
  for (const auto* points : {&body.r, &body.outline})
    for (const Point& p : *points) lowest = std::min(lowest, p[2]);
  return plan->guess(lowest);
}

}  // namespace

Geometry read_body(formats::TableReader& table, const BodyOfPlan* plan) {
  Geometry out;
  BodyGeometry body;
  body.side = read_side(table, plan);
  read_turning(table, body);
  read_named_points(table, body);
  if (table.has("outline"))
    for (const Point& corner : read_points(table, kOutline))
      body.outline.push_back(mirrored(corner, body.side));
  const Point origin = read_origin(table, plan, body);
  append(out.positions, origin);
  out.names.sets["origin"] = {0};
  body.rim = read_rim(table);
  out.elements = {0};
  out.data[datum::kSide.name] = {body.side};
  out.data[datum::kArm.name] = {0, 0, 0};
  const auto names = std::exchange(body.names, {});
  const auto r = std::exchange(body.r, {});
  out.body = std::move(body);
  for (std::size_t k = 0; k < r.size(); ++k) add_body_point(out, names[k], r[k]);
  return out;
}

void add_body_point(Geometry& of, const std::string& name, const Point& r) {
  const Point origin{of.positions[0], of.positions[1], of.positions[2]};
  append(of.positions, placed(origin, of.body->rotation, r));
  of.body->names.push_back(name);
  of.body->r.push_back(r);
  of.names.sets[name] = {static_cast<std::uint32_t>(of.body->r.size())};
}

namespace {

constexpr int kChords = 720;  // of half a rim; their length is that of the half to 1e-6
constexpr double kChordAngle = std::numbers::pi / kChords;

Point at_angle(const BodyRim& rim, double angle) {
  return {rim.at[0], rim.at[1] + 0.5 * rim.width * std::sin(angle),
          rim.at[2] + 0.5 * rim.height * std::cos(angle)};
}

/// Lengths of half a rim from the top to the end of each chord [m].
std::vector<double> half_lengths(const BodyRim& rim) {
  std::vector<double> length{0};
  for (int k = 0; k < kChords; ++k)
    length.push_back(length.back() +
                     distance(at_angle(rim, k * kChordAngle), at_angle(rim, (k + 1) * kChordAngle)));
  return length;
}

}  // namespace

double length_of(const BodyRim& rim) { return 2 * half_lengths(rim).back(); }

Point point_on(const BodyRim& rim, double fraction) {
  const std::vector<double> length = half_lengths(rim);
  const double wanted = 2 * std::abs(fraction) * length.back();
  const auto next = std::clamp<std::ptrdiff_t>(
      std::upper_bound(length.begin(), length.end(), wanted) - length.begin(), 1, kChords);
  const double before = length[static_cast<std::size_t>(next - 1)],
               after = length[static_cast<std::size_t>(next)];
  const double angle = (static_cast<double>(next - 1) + (wanted - before) / (after - before)) * kChordAngle;
  return at_angle(rim, fraction < 0 ? -angle : angle);
}

namespace {

std::string shown(const RigidBody& body, std::size_t point, const BodyGeometry& geometry) {
  return formats::in_quotes(body.name + "." + geometry.names[point]);
}

/// Reports an error if a point of the body also belongs to another body or is the origin of one, because the
/// point would couple the rotations of both bodies.
void check_alone(const Draft& draft, const RigidBody& body, const BodyGeometry& geometry,
                 const std::map<std::uint32_t, std::size_t>& origins, formats::Place place,
                 formats::Diagnostics& diagnostics) {
  const Scene& scene = draft.out.scene;
  std::set<std::uint32_t> own{body.origin};
  for (std::size_t k = 0; k < body.points.size(); ++k) {
    const std::uint32_t node = body.points[k].node;
    const RigidBody* other = body_that_carries(scene, node);
    if (const auto origin = origins.find(node); origin != origins.end())
      other = &scene.bodies[origin->second];
    const bool is_own = !own.insert(node).second;
    if (other || is_own)
      diagnostics.error(place,
                        shown(body, k, geometry) + " is joined to a point of " +
                            (is_own ? "its own body" : "the body " + formats::in_quotes(other->name)) +
                            "; a point belongs to one body alone",
                        "put a short rope between them");
  }
  if (const RigidBody* other = body_that_carries(scene, body.origin))
    diagnostics.error(place,
                      formats::in_quotes(body.name + ".origin") + " is joined to a point of the body " +
                          formats::in_quotes(other->name) + ", but the body carries this point",
                      "put a short rope between them");
}

}  // namespace

void add_bodies(Draft& draft, formats::Diagnostics& diagnostics) {
  Scene& scene = draft.out.scene;
  std::map<std::uint32_t, std::size_t> origins;  // origins of the bodies so far, with the index of the body
  for (std::size_t p = 0; p < draft.geometries.size(); ++p) {
    if (!draft.geometries[p].body) continue;
    const BodyGeometry& geometry = *draft.geometries[p].body;
    const PartGeometry& names = draft.out.parts[p];
    RigidBody body{.name = names.name,
                   .origin = names.nodes[0],
                   .rotation = geometry.rotation,
                   .held_rotation = geometry.held_rotation,
                   .points = {}};
    for (std::size_t k = 0; k < geometry.r.size(); ++k)
      body.points.push_back({names.nodes[k + 1], geometry.r[k]});
    check_alone(draft, body, geometry, origins, names.place, diagnostics);
    origins[body.origin] = scene.bodies.size();
    scene.add_body(std::move(body));
    draft.out.bodies.push_back(
        {static_cast<std::uint32_t>(p), geometry.side, geometry.names, geometry.outline});
  }
  place_points(scene);
}

void place_points(Scene& scene) {
  for (const auto& body : scene.bodies)
    for (const auto& point : body.points) {
      const double* o = &scene.positions[3 * std::size_t{body.origin}];
      const Point at = placed({o[0], o[1], o[2]}, body.rotation, point.r);
      std::copy(at.begin(), at.end(), scene.positions.begin() + 3 * std::ptrdiff_t{point.node});
    }
}

const RigidBody* body_that_carries(const Scene& scene, std::uint32_t node) {
  if (scene.carried.empty() || !scene.carried[node]) return nullptr;
  for (const auto& body : scene.bodies)
    for (const auto& point : body.points)
      if (point.node == node) return &body;
  return nullptr;
}

}  // namespace netloft::scenes
