// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/toml/diagnostics.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace netloft::io {

/// What the elements of a region are, with the numbers that each has of its own:
///   triangles  of netting: the corners in meshes of their panel, U1 V1 U2 V2 U3 V3
///   bars       of a rope: the shares of its length at which each begins and ends
///   twines     bars that stand for several twines: their length in mesh sides, and the number of twines
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

/// Nodes with a name in common: what is held, or carries something.
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

/// Whether a text is a mesh: it begins with `netloft mesh`.
bool is_mesh_text(std::string_view text);

/// Reads a mesh out of a text (README.md of this folder). Errors are located and go to `diagnostics`, where
/// the text is `file`; after an error what could be read is returned.
InputMesh read_mesh(std::string_view text, int file, Diagnostics& diagnostics);

/// The text that read_mesh() reads as this mesh. `source` is a comment of one or more lines.
std::string mesh_text(const InputMesh& mesh, const std::string& source);

/// The shortest text that reads as this number.
std::string spell_number(double value);

}  // namespace netloft::io
