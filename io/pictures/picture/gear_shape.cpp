// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/gear_shape.hpp"

#include "io/results/file/ship.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace netloft::pictures {

namespace {

std::string names_of(const std::vector<results::StoredField>& fields) {
  std::string names;
  for (const auto& field : fields) names += field.name + ", ";
  return names + "part";
}

std::optional<results::StoredField> find_field(const results::StoredShape& stored,
                                               const std::string& wanted) {
  if (wanted == "part") return {};
  for (const auto& field : stored.fields)
    if (wanted.empty() ? !field.is_total : field.name == wanted) return field;
  if (!wanted.empty())
    throw std::invalid_argument(stored.result.path + " has no field " + wanted + "; it has " +
                                names_of(stored.fields));
  return {};
}

std::vector<std::array<double, 3>> same_at_corners(const results::StoredMesh& mesh,
                                                   const std::vector<double>& values) {
  std::vector<std::array<double, 3>> corners;
  for (const auto cell : mesh.triangle_cells) corners.push_back({values[cell], values[cell], values[cell]});
  return corners;
}

}  // namespace

double GearShape::value_of(std::uint32_t cell) const {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[cell];
}

Colour GearShape::colour(results::CellKind kind, std::uint32_t cell, double value) const {
  if (!field) return colour_of_part(stored->mesh.cell_part[cell]);
  const auto& scale = scales[static_cast<std::size_t>(kind)];
  if (!scale || !std::isfinite(value)) return kind == results::CellKind::point ? kFloatColour : kNoValue;
  return colour_at(scale->place(value));
}

Colour GearShape::colour_of_plate(const results::BodyPlate& plate) const {
  const auto cell = stored->mesh.dot_cells[plate.dot];
  const bool is_known =
      !field || (scales[static_cast<std::size_t>(results::CellKind::point)] && std::isfinite(value_of(cell)));
  return is_known ? colour_of_cell(results::CellKind::point, cell) : kBodyColour;
}

bool GearShape::shows_contacts() const {
  return field && !scales[static_cast<std::size_t>(results::CellKind::netting)] &&
         !scales[static_cast<std::size_t>(results::CellKind::rope)];
}

GearShape shape_of(const results::StoredShape& stored, std::size_t state, const Colouring& colouring) {
  GearShape shape;
  shape.stored = &stored;
  const auto points = stored.points(state);
  for (std::size_t n = 0; n < stored.mesh.n_points; ++n)
    shape.nodes.push_back({points[3 * n], points[3 * n + 1], points[3 * n + 2]});
  shape.fish = results::catch_body_of(stored, state);
  shape.plates = results::plates_of(stored, state);
  for (const auto& ship : results::ships_of(stored, state)) {
    const auto triangles = results::triangles_of(ship);
    shape.hulls.insert(shape.hulls.end(), triangles.begin(), triangles.end());
  }
  shape.field = find_field(stored, colouring.field);
  if (!shape.field) return shape;
  shape.values = stored.field(shape.field->name, state);
  shape.scales = results::scales_of(results::spreads_of(stored, shape.field->name), colouring.is_logarithmic);
  shape.at_corners = colouring.by_element ? same_at_corners(stored.mesh, shape.values)
                                          : results::values_at_corners(stored.mesh, shape.values);
  return shape;
}

std::optional<Framing> framing_called(const std::string& name) {
  if (name == "netting") return Framing::netting;
  if (name == "boards") return Framing::boards;
  if (name == "all") return Framing::all;
  return {};
}

std::vector<Point3> extent_of(const GearShape& shape, Framing framing) {
  const results::StoredMesh& mesh = shape.stored->mesh;
  std::vector<Point3> points;
  const auto take = [&](const Point3& place) {
    points.push_back(place);
    if (shape.stored->result.is_half()) points.push_back({place[0], -place[1], place[2]});
  };
  for (const auto& triangle : mesh.triangles)
    for (const auto node : triangle) take(shape.nodes[node]);
  if (points.empty()) framing = Framing::all;
  if (framing == Framing::netting) return points;
  for (const auto& plate : shape.plates)
    for (const auto& corner : plate.triangles) take(corner);
  if (framing == Framing::boards) return points;
  for (const auto& bar : mesh.bars)
    for (const auto node : bar) take(shape.nodes[node]);
  for (const auto& corner : shape.hulls) take(corner);
  return points;
}

}  // namespace netloft::pictures
