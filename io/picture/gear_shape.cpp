// SPDX-License-Identifier: BSD-3-Clause
#include "io/picture/gear_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace netloft::io {

namespace {

std::string names_of(const std::vector<StoredField>& fields) {
  std::string names;
  for (const auto& field : fields) names += field.name + ", ";
  return names + "part";
}

std::optional<StoredField> find_field(const StoredResult& result, const std::string& wanted) {
  if (wanted == "part") return {};
  for (const auto& field : result.fields)
    if (wanted.empty() ? !field.is_total : field.name == wanted) return field;
  if (!wanted.empty())
    throw std::invalid_argument(result.path.string() + " has no field " + wanted + "; it has " +
                                names_of(result.fields));
  return {};
}

std::vector<std::array<double, 3>> same_at_corners(const StoredMesh& mesh,
                                                   const std::vector<double>& values) {
  std::vector<std::array<double, 3>> corners;
  for (const auto cell : mesh.triangle_cells) corners.push_back({values[cell], values[cell], values[cell]});
  return corners;
}

}  // namespace

double GearShape::value_of(std::uint32_t cell) const {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[cell];
}

Colour GearShape::colour(CellKind kind, std::uint32_t cell, double value) const {
  if (!field) return colour_of_part(result->mesh.cell_part[cell]);
  const auto& scale = scales[static_cast<std::size_t>(kind)];
  if (!scale || !std::isfinite(value)) return kind == CellKind::point ? kFloatColour : kNoValue;
  return colour_at(scale->place(value));
}

bool GearShape::shows_contacts() const {
  return field && !scales[static_cast<std::size_t>(CellKind::netting)] &&
         !scales[static_cast<std::size_t>(CellKind::rope)];
}

GearShape shape_of(const StoredResult& result, std::size_t state, const Colouring& colouring) {
  GearShape shape;
  shape.result = &result;
  const auto points = result.points(state);
  for (std::size_t n = 0; n < result.mesh.n_points; ++n)
    shape.nodes.push_back({points[3 * n], points[3 * n + 1], points[3 * n + 2]});
  shape.fish = catch_body_of(result, state);
  shape.field = find_field(result, colouring.field);
  if (!shape.field) return shape;
  shape.values = result.field(shape.field->name, state);
  shape.scales = scales_of(spreads_of(result, shape.field->name), colouring.is_logarithmic);
  shape.at_corners = colouring.by_element ? same_at_corners(result.mesh, shape.values)
                                          : values_at_corners(result.mesh, shape.values);
  return shape;
}

std::vector<Point3> extent_of(const GearShape& shape, bool with_ropes) {
  const StoredMesh& mesh = shape.result->mesh;
  std::vector<Point3> points;
  const auto take = [&](std::uint32_t node) {
    points.push_back(shape.nodes[node]);
    if (shape.result->is_half) points.push_back({points.back()[0], -points.back()[1], points.back()[2]});
  };
  for (const auto& triangle : mesh.triangles)
    for (const auto node : triangle) take(node);
  if (with_ropes || points.empty())
    for (const auto& bar : mesh.bars)
      for (const auto node : bar) take(node);
  return points;
}

}  // namespace netloft::io
