// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/vtk_cells.hpp"

namespace netloft::formats {

const double* VtkCells::numbers(const std::string& array, std::size_t components, std::size_t cell) const {
  const auto known = arrays.find(array);
  if (known == arrays.end() || known->second.components != components) return nullptr;
  const auto& values = known->second.values;
  return components * (cell + 1) <= values.size() ? &values[components * cell] : nullptr;
}

std::string VtkCells::region_of(std::size_t cell, const char* otherwise) const {
  const double* number = numbers("region", 1, cell);
  if (!number) return otherwise;
  if (*number >= 0 && *number < static_cast<double>(names.size()))
    return names[static_cast<std::size_t>(*number)];
  return "region-" + spell_number(*number);
}

namespace {

void add_line(const VtkCells& cells, std::size_t c, MeshBuilder& builder) {
  const auto& nodes = cells.nodes[c];
  const double *shares = cells.numbers("shares", 2, c), *twines = cells.numbers("twines", 2, c);
  const bool is_netting = twines && twines[1] > 0;
  if (nodes.size() > 2) shares = nullptr;
  MeshRegion& region =
      builder.region(cells.region_of(c, "rope"), is_netting ? RegionKind::twines : RegionKind::bars);
  if (!is_netting && region.size() > 0 && region.numbers.empty() != !shares)
    return builder.error(cells.places[c],
                         "some bars of this rope state their share of the rope, and others do not");
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    builder.add_element(region, &nodes[k], is_netting ? twines : shares, cells.places[c]);
}

/// Adds one cell. Returns false if further cells cannot be read.
bool add_cell(const VtkCells& cells, std::size_t c, MeshBuilder& builder) {
  const auto& nodes = cells.nodes[c];
  const int type = cells.types[c];
  if (type == vtk::kVertex || type == vtk::kPolyVertex) {
    auto& set = builder.set(cells.region_of(c, "nodes"));
    set.nodes.insert(set.nodes.end(), nodes.begin(), nodes.end());
  } else if (type == vtk::kTriangle && nodes.size() == 3) {
    const double* corners = cells.numbers("panel_corners", 6, c);
    if (!corners)
      return builder.error(cells.places[c],
                           "triangles need the array panel_corners on cells, U V of their corners in meshes"),
             false;
    builder.add_element(builder.region(cells.region_of(c, "netting"), RegionKind::triangles), nodes.data(),
                        corners, cells.places[c]);
  } else if ((type == vtk::kLine || type == vtk::kPolyLine) && nodes.size() >= 2)
    add_line(cells, c, builder);
  else
    builder.error(cells.places[c],
                  "cells of type " + std::to_string(type) + " with " + std::to_string(nodes.size()) +
                      " nodes are not read",
                  "only triangles, lines and vertices are read");
  return builder.goes_on();
}

}  // namespace

void add_vtk_cells(const VtkCells& cells, const Place& place, MeshBuilder& builder) {
  if (cells.types.size() != cells.nodes.size())
    return builder.error(place, "there are " + std::to_string(cells.nodes.size()) + " cells and " +
                                    std::to_string(cells.types.size()) + " types of cells");
  for (std::size_t c = 0; c < cells.nodes.size(); ++c)
    if (!add_cell(cells, c, builder)) return;
}

}  // namespace netloft::formats
