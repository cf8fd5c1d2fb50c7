// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh_builder.hpp"

#include <map>

namespace netloft::formats {

namespace vtk {
inline constexpr int kVertex = 1, kPolyVertex = 2, kLine = 3, kPolyLine = 4, kTriangle = 5;  // types of cells
}

/// Cells of an unstructured grid of VTK, in whatever file they stand, with the arrays on them that say what
/// they are: `region`, `panel_corners`, `shares`, `twines` (README.md).
struct VtkCells {
  struct Array {
    std::size_t components = 1;
    std::vector<double> values;
  };
  std::vector<std::vector<std::uint32_t>> nodes;
  std::vector<Place> places;
  std::vector<int> types;
  std::map<std::string, Array> arrays;
  std::vector<std::string> names;  // of regions

  /// The numbers of a cell in an array; null if there is none with so many components.
  const double* numbers(const std::string& array, std::size_t components, std::size_t cell) const;
  /// "wing", "region-3", or the word that is given.
  std::string region_of(std::size_t cell, const char* otherwise) const;
};

/// Puts cells whose nodes are there into a mesh. `place` is that of all of them.
void add_vtk_cells(const VtkCells& cells, const Place& place, MeshBuilder& builder);

}  // namespace netloft::formats
