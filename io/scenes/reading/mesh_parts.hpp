// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/toml/document.hpp"
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/joiner.hpp"

#include <filesystem>
#include <memory>

namespace netloft::scenes {

/// The keys of a part that stands on a region of a mesh instead of being divided by the program.
const std::vector<GeometryKey>& mesh_keys(Layout layout);

/// Parts that stand on meshes in files of their own, and the nodes that these parts have in common.
class MeshParts {
 public:
  /// Names of files are relative to `folder`, that of the scene.
  MeshParts(std::filesystem::path folder, formats::Diagnostics& diagnostics);

  /// The region of the mesh that the part names, as part number `part` of the scene. Elements on triangles
  /// take triangles, with the data u, v, bar_length, to_aft (meshes to the largest V of the region); elements
  /// on bars take bars, with the data rest_length, and the sets start, end and middle if they are one line;
  /// panels in bars take bars of twines, with the data rest_length and parallel. Sets of the mesh become
  /// those of the part, as far as it has their nodes.
  Geometry read(const ElementType& type, const std::string& name, std::size_t part,
                formats::TableReader& table);

  /// Makes nodes of a mesh that several parts use one node.
  void connect(Joiner& joiner) const;

  /// Whether a mesh could not be read, so that parts on it have no true number of nodes.
  bool has_failed() const;

  /// The files that were read.
  const std::vector<formats::SourceFile>& files() const { return files_; }

 private:
  struct Standing {
    std::size_t part;
    const formats::InputMesh* mesh;
    std::vector<std::uint32_t> nodes;  // of the mesh, by own number
  };

  const formats::InputMesh* find_mesh(formats::TableReader& table);
  const formats::MeshRegion* find_region(const formats::InputMesh& mesh, formats::RegionKind kind,
                                         const std::string& name, formats::TableReader& table);

  std::filesystem::path folder_;
  formats::Diagnostics& diagnostics_;
  std::map<std::string, std::unique_ptr<formats::InputMesh>> meshes_;  // by name; null: it cannot be read
  std::vector<Standing> standing_;
  std::vector<formats::SourceFile> files_;
};

}  // namespace netloft::scenes
