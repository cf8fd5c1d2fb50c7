// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/write_parts.hpp"
#include "io/results/file/no_number.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/scenes/reading/beds.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace netloft::results {

namespace {

double diameter_of(const Part& part) {
  for (const auto& known : {scenes::parameter::kTwineDiameter, scenes::parameter::kRopeDiameter,
                            scenes::parameter::kFloatDiameter})
    if (const double* diameter = find_number(part.parameters, known.name);
        diameter && std::isfinite(*diameter))
      return *diameter;
  return kNone;
}

/// The value of a datum for the first element of the part; NaN if the part has no such datum.
double first_of(const Part& part, const HostDatum& datum) {
  const auto* numbers = find_data(part.data, datum);
  return numbers ? numbers->front() : kNone;
}

using Axes = std::array<double, 4>;

/// Returns the coefficients a, b, c, d of the twine coordinates u = a U + b V, v = c U + d V, where U, V are
/// the panel coordinates. They are the same over the whole panel, and are found from the corners of one
/// triangle. This triangle has no node on a seam that closes the panel, because such a node has two pairs (U,
/// V).
Axes axes_of(const Part& part, const scenes::PartGeometry& geometry) {
  const auto *u = find_data(part.data, datum::kU), *v = find_data(part.data, datum::kV);
  Axes axes{kNone, kNone, kNone, kNone};
  if (!u || !v || geometry.panel.empty()) return axes;
  std::map<std::uint32_t, std::array<double, 2>> places;
  for (std::size_t own = 0; own < geometry.panel.size(); ++own)
    if (!places.emplace(geometry.nodes[own], geometry.panel[own]).second)
      places[geometry.nodes[own]] = {kNone, kNone};
  for (std::size_t t = 0; t + 2 < part.nodes.size() && t + 2 < u->size(); t += 3) {
    std::array<std::array<double, 2>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = places[part.nodes[t + k]];
    const double ax = p[1][0] - p[0][0], ay = p[1][1] - p[0][1], bx = p[2][0] - p[0][0],
                 by = p[2][1] - p[0][1], twice = ax * by - ay * bx;
    if (!(std::abs(twice) > 1e-9)) continue;
    const auto solve = [&](const std::vector<double>& w) {
      const double da = w[t + 1] - w[t], db = w[t + 2] - w[t];
      return std::array<double, 2>{(da * by - db * ay) / twice, (db * ax - da * bx) / twice};
    };
    const auto first = solve(*u), second = solve(*v);
    return {first[0], first[1], second[0], second[1]};
  }
  return axes;
}

/// The table of parts in a file: names, types, and the numbers that a picture needs.
struct PartRows {
  std::vector<std::string> names, types;
  std::vector<double> diameters, bars, axes, sheet;

  void add(const Part& part, const scenes::PartGeometry* geometry, const scenes::SheetPlace* place) {
    names.push_back(part.name);
    types.push_back(part.type);
    diameters.push_back(diameter_of(part));
    bars.push_back(first_of(part, datum::kBarLength));
    const Axes of_twines = geometry ? axes_of(part, *geometry) : Axes{kNone, kNone, kNone, kNone};
    axes.insert(axes.end(), of_twines.begin(), of_twines.end());
    const scenes::SheetPlace at =
        place ? *place : scenes::SheetPlace{kNone, kNone, kNone, kNone, kNone, kNone};
    sheet.insert(sheet.end(), {at.x, at.y, at.x_across, at.y_across, at.x_deep, at.y_deep});
  }
};

/// Writes the heights of a relief on an even grid, for pictures. The relief itself is a smooth surface.
void write_relief(formats::Tree& tree, const Surface& relief) {
  constexpr std::size_t kPlaces = 65;
  if (relief.empty()) return;
  std::vector<double> x, y, height;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double s = static_cast<double>(i) / (kPlaces - 1);
    x.push_back(std::lerp(relief.first_of_x(), relief.last_of_x(), s));
    y.push_back(std::lerp(relief.first_of_y(), relief.last_of_y(), s));
  }
  for (const double at_x : x)
    for (const double at_y : y) height.push_back(relief.at(at_x, at_y));
  const std::string at = "/netloft/seabed/relief/";
  tree.write_reals(at + "x", x, "m", "places");
  tree.write_reals(at + "y", y, "m", "places");
  tree.write_matrix(at + "height", height, kPlaces, "m", "height of the relief above the plane, [x, y]");
}

void write_plane(formats::Tree& tree, const scenes::BedPlane& plane, const char* doc) {
  tree.write_real("/netloft/seabed/depth", plane.depth, "m", doc);
  tree.write_real("/netloft/seabed/slope_x", plane.slope_x, "1", doc);
  tree.write_real("/netloft/seabed/slope_y", plane.slope_y, "1", doc);
}

/// Writes the seabed: that of the scene or, if the scene has none, of the first part with a bed of its own.
void write_seabed(formats::Tree& tree, const Scene& scene) {
  if (scene.bed.is_there) {
    const char* doc = "seabed: z = -depth + slope_x x + slope_y y, and a relief where there is one";
    write_plane(tree, {scene.bed.depth, scene.bed.slope_x, scene.bed.slope_y}, doc);
    write_relief(tree, scene.bed.relief);
    return;
  }
  for (const auto& part : scene.parts) {
    const auto plane = scenes::bed_plane_of(part);
    if (!plane) continue;
    return write_plane(tree, *plane, "seabed: z = -depth + slope_x x + slope_y y");
  }
}

/// Writes rigid bodies: names, origins, points and outlines. The point field `rotation` has their orientation
/// in every state.
void write_bodies(formats::Tree& tree, const scenes::LoadedScene& loaded) {
  if (loaded.bodies.empty()) return;
  std::vector<std::string> names, points;
  std::vector<std::int64_t> origins, nodes, of_points, of_corners;
  std::vector<double> sides, places, corners;
  for (std::size_t b = 0; b < loaded.bodies.size(); ++b) {
    const RigidBody& body = loaded.scene.bodies[b];
    const scenes::BodyInScene& look = loaded.bodies[b];
    names.push_back(body.name);
    origins.push_back(body.origin);
    sides.push_back(look.side);
    for (std::size_t k = 0; k < body.points.size(); ++k) {
      points.push_back(look.points[k]);
      nodes.push_back(body.points[k].node);
      of_points.push_back(static_cast<std::int64_t>(b));
      places.insert(places.end(), body.points[k].r.begin(), body.points[k].r.end());
    }
    for (const auto& corner : look.outline) {
      of_corners.push_back(static_cast<std::int64_t>(b));
      corners.insert(corners.end(), corner.begin(), corner.end());
    }
  }
  const std::string at = "/netloft/bodies/";
  tree.write_strings(at + "name", names);
  tree.write_ints(at + "origin", origins, "1", "node of its origin");
  tree.write_reals(at + "side", sides, "1", "1 to starboard, -1 to port");
  if (!points.empty()) {
    tree.write_strings(at + "points/name", points);
    tree.write_ints(at + "points/body", of_points, "1", "body that carries the point");
    tree.write_ints(at + "points/node", nodes, "1", "node of the point");
    tree.write_matrix(at + "points/place", places, 3, "m", "position of the point in the axes of the body");
  }
  if (corners.empty()) return;
  tree.write_ints(at + "outline/body", of_corners, "1", "body of each corner of an outline");
  tree.write_matrix(at + "outline/place", corners, 3, "m", "corners in the axes of the body, in their order");
}

}  // namespace

void write_parts(formats::Tree& tree, const scenes::LoadedScene& loaded) {
  PartRows rows;
  for (std::size_t p = 0; p < loaded.scene.parts.size(); ++p) {
    const Part& part = loaded.scene.parts[p];
    if (part.companion) continue;
    const scenes::SheetPlace* place = nullptr;
    if (loaded.gear)
      if (const auto at = loaded.gear->sheet.find(part.name); at != loaded.gear->sheet.end())
        place = &at->second;
    rows.add(part, p < loaded.parts.size() ? &loaded.parts[p] : nullptr, place);
  }
  const std::string at = "/netloft/parts/";
  tree.write_strings(at + "name", rows.names);
  tree.write_strings(at + "type", rows.types);
  tree.write_reals(at + "diameter", rows.diameters, "m",
                   "diameter of the twine, rope or float of the part; NaN if it has none");
  tree.write_reals(at + "bar", rows.bars, "m",
                   "length of a bar of the meshes of the part; NaN if it is no netting");
  tree.write_matrix(at + "twine_axes", rows.axes, 4, "1",
                    "a, b, c, d: on the twines of netting u = a U + b V or v = c U + d V is an integer");
  tree.write_matrix(at + "sheet", rows.sheet, 6, "m",
                    "place on the plan: origin, vector of one mesh across, vector of one mesh deep");
  write_bodies(tree, loaded);
  write_seabed(tree, loaded.scene);
}

}  // namespace netloft::results
