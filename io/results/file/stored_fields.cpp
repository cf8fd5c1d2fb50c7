// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/element_outputs.hpp"
#include "io/results/figures/materials.hpp"
#include "io/results/file/no_number.hpp"
#include "io/results/file/stored_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::results {

namespace {

// Names of fields that are computed from stored fields: the larger tension of the two twine directions, the
// opening of meshes, and the water force per length of rope or area of netting.
constexpr const char *kTension = "tension", *kOpening = "opening", *kWaterForce = "water_force";
// Outputs that are totals over an element, and therefore depend on its size.
constexpr std::array kTotals = {output::kDrag.name, output::kKnots.name, output::kMass.name,
                                output::kTwineArea.name, output::kVolume.name};

}  // namespace

void StoredShape::read_fields() {
  const auto label = [&](const std::string& at, const char* name, const char* otherwise) {
    return reader_.has_attribute(at, name) ? reader_.text_attribute(at, name) : std::string(otherwise);
  };
  const auto everywhere = [](const std::string& unit) { return std::array{unit, unit, unit}; };
  std::vector<StoredField> stored;
  bool has_tension = false;
  for (const auto& name : reader_.list("/VTKHDF/CellData")) {
    const std::string at = "/VTKHDF/CellData/" + name;
    if (name == "part" || name == "panel_corners" || reader_.shape(at).size() > 1) continue;
    has_tension |= std::ranges::find(kTensions, name) != kTensions.end();
    const bool is_total = std::find(kTotals.begin(), kTotals.end(), name) != kTotals.end();
    if (name != kTension)
      stored.push_back({name, everywhere(label(at, "unit", "1")), label(at, "doc", ""), is_total});
    if (name == output::kHalfAngle.name)
      fields.push_back({kOpening, everywhere("1"), "width of the meshes over their stretched length"});
    if (name == output::kDrag.name)
      fields.push_back({kWaterForce,
                        {"N/m2", "N/m", "N"},
                        "force of the water per area of netting and per length of rope"});
  }
  if (has_tension)
    fields.insert(fields.begin(),
                  {kTension, everywhere("N"),
                   "tension in ropes, and in twines of netting: the larger of both directions"});
  fields.insert(fields.end(), stored.begin(), stored.end());
}

/// Marks the parts whose elements are on single nodes and have a normal force: they model contact with a bed.
void StoredShape::find_contacts() {
  for (const auto& field : fields) {
    if (field.name != output::kNormalForce.name) continue;
    const auto force = whole(reader_.field(formats::Location::kCell, field.name, times.size() - 1),
                             mesh.n_cells, "field " + field.name);
    for (const auto cell : mesh.dot_cells)
      if (std::isfinite(force[cell])) parts[mesh.cell_part[cell]].is_contact = true;
  }
}

std::vector<double> StoredShape::points(std::size_t state) const {
  return whole(reader_.points(state), 3 * mesh.n_points, "shape");
}

std::vector<double> StoredShape::field(const std::string& name, std::size_t state) const {
  if (name == kOpening) return opening(state);
  if (name == kTension) return tension(state);
  if (name == kWaterForce) return water_force(state);
  return whole(reader_.field(formats::Location::kCell, name, state), mesh.n_cells, "field " + name);
}

std::vector<double> StoredShape::opening(std::size_t state) const {
  auto values = field(output::kHalfAngle.name, state);
  for (double& value : values) value = std::sin(value);
  return values;
}

std::vector<double> StoredShape::tension(std::size_t state) const {
  std::vector<double> values(mesh.n_cells, kNone);
  for (const auto one : kTensions) {
    if (!reader_.has("/VTKHDF/CellData/" + std::string(one))) continue;
    const auto more = reader_.field(formats::Location::kCell, std::string(one), state);
    for (std::size_t c = 0; c < values.size() && c < more.size(); ++c)
      if (!(values[c] > more[c]) && std::isfinite(more[c])) values[c] = more[c];
  }
  return values;
}

std::vector<double> StoredShape::water_force(std::size_t state) const {
  auto force = field(output::kDrag.name, state);
  const auto x = points(state);
  const auto from_to = [&](std::uint32_t a, std::uint32_t b) {
    return std::array{x[3 * b] - x[3 * a], x[3 * b + 1] - x[3 * a + 1], x[3 * b + 2] - x[3 * a + 2]};
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto u = from_to(a, b), v = from_to(a, c);
    const double area =
        std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    double& value = force[mesh.triangle_cells[t]];
    value = area > 0 ? value / area : kNone;
  }
  for (std::size_t i = 0; i < mesh.bars.size(); ++i) {
    const auto d = from_to(mesh.bars[i][0], mesh.bars[i][1]);
    const double length = std::hypot(d[0], d[1], d[2]);
    double& value = force[mesh.bar_cells[i]];
    value = length > 0 ? value / length : kNone;
  }
  return force;
}

std::vector<double> StoredShape::node_field(const std::string& name, std::size_t state) const {
  if (!reader_.has("/VTKHDF/PointData/" + name)) return {};
  return whole(reader_.field(formats::Location::kPoint, name, state), 3 * mesh.n_points, "field " + name);
}

}  // namespace netloft::results
