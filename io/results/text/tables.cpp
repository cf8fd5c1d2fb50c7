// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/tables.hpp"

#include "io/formats/text/csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::results {

namespace {

using formats::csv_field, formats::csv_number;

std::string with_unit(const std::string& name, const std::string& unit) {
  return csv_field(unit == "1" ? name : name + " [" + unit + "]");
}

/// The units of a field: one, or "N/m2, N/m, N" if they differ between kinds of cells.
std::string units_of(const StoredField& field) {
  std::string units = field.units.front();
  for (std::size_t kind = 1; kind < kCellKinds; ++kind)
    if (field.units[kind] != field.units[kind - 1]) units += ", " + field.units[kind];
  return units;
}

std::string part_of(const StoredShape& stored, std::uint32_t part) {
  return csv_field(stored.parts[part].name);
}

/// Nodes of every cell, separated by spaces.
std::vector<std::string> nodes_of_cells(const StoredMesh& mesh) {
  std::vector<std::string> nodes(mesh.n_cells);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    nodes[mesh.triangle_cells[t]] =
        fmt::format("{} {} {}", mesh.triangles[t][0], mesh.triangles[t][1], mesh.triangles[t][2]);
  for (std::size_t b = 0; b < mesh.bars.size(); ++b)
    nodes[mesh.bar_cells[b]] = fmt::format("{} {}", mesh.bars[b][0], mesh.bars[b][1]);
  for (std::size_t d = 0; d < mesh.dots.size(); ++d)
    nodes[mesh.dot_cells[d]] = fmt::format("{}", mesh.dots[d]);
  return nodes;
}

}  // namespace

std::string nodes_csv(const StoredShape& stored, std::size_t state) {
  const auto points = stored.points(state), reaction = stored.node_field("reaction", state);
  std::string text = "node,part,number in part,x [m],y [m],z [m]";
  if (!reaction.empty()) text += ",held x [N],held y [N],held z [N]";
  text += "\n";
  for (std::size_t n = 0; n < stored.mesh.n_points; ++n) {
    text += fmt::format("{},{},{}", n, part_of(stored, stored.mesh.node_part[n]), stored.mesh.node_number[n]);
    for (std::size_t axis = 0; axis < 3; ++axis) text += "," + csv_number(points[3 * n + axis]);
    for (std::size_t axis = 0; axis < 3 && !reaction.empty(); ++axis)
      text += "," + csv_number(reaction[3 * n + axis]);
    text += "\n";
  }
  return text;
}

std::string elements_csv(const StoredShape& stored, std::size_t state) {
  std::string text = "element,part,nodes";
  std::vector<std::vector<double>> fields;
  for (const auto& field : stored.fields) {
    text += "," + with_unit(field.name, units_of(field));
    fields.push_back(stored.field(field.name, state));
  }
  text += "\n";
  const auto nodes = nodes_of_cells(stored.mesh);
  for (std::size_t c = 0; c < stored.mesh.n_cells; ++c) {
    text += fmt::format("{},{},{}", c, part_of(stored, stored.mesh.cell_part[c]), nodes[c]);
    for (const auto& values : fields) text += "," + csv_number(values[c]);
    text += "\n";
  }
  return text;
}

}  // namespace netloft::results
