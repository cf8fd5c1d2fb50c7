// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh_builder.hpp"

#include <map>

namespace netloft::formats {

namespace vtk {
inline constexpr int kVertex = 1, kPolyVertex = 2, kLine = 3, kPolyLine = 4, kTriangle = 5;  // types of cells
}

/// Cells of an unstructured grid of VTK, from a file of any format, and the arrays that describe the cells:
/// `region`, `panel_corners`, `shares`, `twines` (MESH.md).
struct VtkCells {
  struct Array {
    std::size_t components = 1;
    std::vector<double> values;
  };
  std::vector<std::vector<std::uint32_t>> nodes;
  std::vector<Place> places;
  std::vector<int> types;
  std::map<std::string, Array> arrays;
  std::vector<std::string> names;  // names of regions

  /// The numbers of a cell in an array; nullptr if no such array has this number of components.
  const double* numbers(const std::string& array, std::size_t components, std::size_t cell) const;
  /// The name of the region of a cell: "wing", "region-3", or `otherwise` if the cells have no array
  /// `region`.
  std::string region_of(std::size_t cell, const char* otherwise) const;
};

/// Adds cells to a mesh that has their nodes already. Errors of any cell are reported at `place`.
void add_vtk_cells(const VtkCells& cells, const Place& place, MeshBuilder& builder);

}  // namespace netloft::formats
