// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace netloft::formats {

/// The kind of elements of a region, and the numbers of each element:
///   triangles  of netting: the panel coordinates of the corners [meshes], U1 V1 U2 V2 U3 V3
///   bars       of a rope: the fractions of the rope length at which the bar begins and ends
///   twines     bars that represent several twines: length of the bar [mesh sides], number of twines
enum class RegionKind { triangles, bars, twines };

const char* name_of(RegionKind kind);
constexpr std::size_t nodes_in(RegionKind kind) { return kind == RegionKind::triangles ? 3 : 2; }
constexpr std::size_t numbers_in(RegionKind kind) { return kind == RegionKind::triangles ? 6 : 2; }

/// The elements of one part of a gear.
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

/// A gear that another program has divided into triangles and bars: nodes, and regions of elements. Regions
/// are connected at nodes that they share.
struct InputMesh {
  std::vector<double> positions;  // x y z of each node [m]
  std::vector<MeshRegion> regions;
  std::vector<MeshSet> sets;

  std::size_t node_count() const { return positions.size() / 3; }
  const MeshRegion* find(const std::string& region) const;
};

/// A fault of a single element of a mesh, independent of the other elements.
struct ElementFault {
  bool is_of_nodes;  // whether the fault is in the nodes; otherwise in the numbers
  const char* message;
};
std::optional<ElementFault> fault_of(const MeshRegion& region, std::size_t element);

inline constexpr std::size_t kMostNodes = 4000000, kMostElements = 4000000;  // limits for one mesh
inline constexpr double kFarthest = 1e6;  // limit of coordinates, in metres and in meshes

/// Whether a text is a mesh, that is, whether it begins with `netloft mesh`.
bool is_mesh_text(std::string_view text);

/// Reads a mesh from a text (MESH.md). Adds errors to `diagnostics`, where the text has the index `file`.
/// After an error, the result contains everything that could be read.
InputMesh read_mesh(std::string_view text, int file, Diagnostics& diagnostics);

/// Reads a mesh in any text format (MESH.md). The beginning of the text determines the format: `netloft
/// mesh`, `# vtk DataFile`, otherwise OBJ.
InputMesh read_any_mesh(std::string_view text, int file, Diagnostics& diagnostics);

/// Reads Wavefront OBJ: corners are `vertex/texture`; the texture coordinates are U and V in netting, and the
/// fraction of the length on a rope; groups are regions, points are sets. obj_text() omits bars of several
/// twines, which OBJ cannot express.
InputMesh read_obj(std::string_view text, int file, Diagnostics& diagnostics);
std::string obj_text(const InputMesh& mesh, const std::string& source);

/// Reads a VTK legacy file in ASCII with an unstructured grid of triangles, lines and vertices. Arrays on
/// cells contain the numbers of elements: `region`, `panel_corners` (6 per triangle), `shares` and `twines`
/// (2 per line). The array of strings `region_names` has the names of regions.
InputMesh read_vtk(std::string_view text, int file, Diagnostics& diagnostics);
std::string vtk_text(const InputMesh& mesh, const std::string& source);

bool is_hdf5(std::string_view bytes);

/// Reads VTKHDF: an unstructured grid with the arrays of VTK legacy files, at its last time; or a result of
/// Netloft, whose parts become regions. Errors have no line; they name the dataset.
InputMesh read_vtkhdf(const std::filesystem::path& path, int file, Diagnostics& diagnostics);

/// The text from which read_mesh() reads this mesh. `source` is a comment of one or more lines.
std::string mesh_text(const InputMesh& mesh, const std::string& source);

/// A text as a comment, each line as "# …"; empty for an empty text.
std::string comment_of(const std::string& source);

/// The shortest text from which the same number is read.
std::string spell_number(double value);

}  // namespace netloft::formats
