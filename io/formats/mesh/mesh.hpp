// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace netloft::formats {

/// The elements of a region, and the numbers of each element:
///   triangles  of netting: the corners in meshes of their panel, U1 V1 U2 V2 U3 V3
///   bars       of a rope: the shares of its length at which each begins and ends
///   twines     bars that represent several twines: their length in mesh sides, and the number of twines
enum class RegionKind { triangles, bars, twines };

const char* name_of(RegionKind kind);
constexpr std::size_t nodes_in(RegionKind kind) { return kind == RegionKind::triangles ? 3 : 2; }
constexpr std::size_t numbers_in(RegionKind kind) { return kind == RegionKind::triangles ? 6 : 2; }

/// Elements that make one part of a gear.
struct MeshRegion {
  RegionKind kind = RegionKind::triangles;
  std::string name;
  std::vector<std::uint32_t> nodes = {};
  std::vector<double> numbers = {};
  std::size_t size() const { return nodes.size() / nodes_in(kind); }
};

/// Nodes with a common name, for holds and loads.
struct MeshSet {
  std::string name;
  std::vector<std::uint32_t> nodes = {};
};

/// A gear divided into triangles and bars by somebody else: nodes, and regions on them. Regions that use the
/// same node are connected there.
struct InputMesh {
  std::vector<double> positions;  // x y z of each node [m]
  std::vector<MeshRegion> regions;
  std::vector<MeshSet> sets;

  std::size_t node_count() const { return positions.size() / 3; }
  const MeshRegion* find(const std::string& region) const;
};

/// A fault of one element, found without the others.
struct ElementFault {
  bool is_of_nodes;  // else of its numbers
  const char* message;
};
std::optional<ElementFault> fault_of(const MeshRegion& region, std::size_t element);

inline constexpr std::size_t kMostNodes = 4000000, kMostElements = 4000000;  // of one mesh
inline constexpr double kFarthest = 1e6;                                     // coordinates [m] and meshes

/// Whether a text is a mesh: it begins with `netloft mesh`.
bool is_mesh_text(std::string_view text);

/// Reads a mesh from a text (MESH.md). Errors are added to `diagnostics` with their places, where the text is
/// `file`; after an error the result contains whatever could be read.
InputMesh read_mesh(std::string_view text, int file, Diagnostics& diagnostics);

/// Reads a mesh in any text format (MESH.md). The beginning of the text determines the format: `netloft
/// mesh`, `# vtk DataFile`, otherwise OBJ.
InputMesh read_any_mesh(std::string_view text, int file, Diagnostics& diagnostics);

/// Wavefront OBJ: corners are `vertex/texture`, whose texture coordinates are U and V, or the fraction of a
/// rope; groups are regions, points are sets. OBJ has no bars of several twines; they are left out.
InputMesh read_obj(std::string_view text, int file, Diagnostics& diagnostics);
std::string obj_text(const InputMesh& mesh, const std::string& source);

/// VTK legacy files in ASCII with an unstructured grid: triangles, lines and vertices; numbers are in
/// arrays on cells, `region`, `panel_corners` (6 of a triangle), `shares` and `twines` (2 of a line), and
/// names of regions in the array of strings `region_names`.
InputMesh read_vtk(std::string_view text, int file, Diagnostics& diagnostics);
std::string vtk_text(const InputMesh& mesh, const std::string& source);

/// Whether bytes are those of an HDF5 file.
bool is_hdf5(std::string_view bytes);

/// VTKHDF: an unstructured grid with the arrays of VTK legacy files, at its last time; or a result of
/// Netloft, whose parts are the regions. Errors have no line; they name the data set.
InputMesh read_vtkhdf(const std::filesystem::path& path, int file, Diagnostics& diagnostics);

/// The text that read_mesh() reads as this mesh. `source` is a comment of one or more lines.
std::string mesh_text(const InputMesh& mesh, const std::string& source);

/// A text of one or more lines as a comment, "# …" each; empty for an empty text.
std::string comment_of(const std::string& source);

/// The shortest text that reads as this number.
std::string spell_number(double value);

}  // namespace netloft::formats
