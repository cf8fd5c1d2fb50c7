// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/toml/document.hpp"
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/joiner.hpp"

#include <filesystem>
#include <memory>

namespace netloft::scenes {

/// The geometry keys of a part whose elements are a region of a mesh file.
const std::vector<GeometryKey>& mesh_keys(Layout layout);

/// Reads parts whose elements come from mesh files, and joins the nodes that parts on the same mesh share.
class MeshParts {
 public:
  /// Names of files are relative to `folder`, the folder of the scene.
  MeshParts(std::filesystem::path folder, formats::Diagnostics& diagnostics);

  /// Reads the region of a mesh that the part names; `part` is the index of the part in the scene. The
  /// element type decides which region is needed: triangles, with the data u, v, bar_length and to_aft
  /// (meshes to the largest V of the region); bars, with the data rest_length, and with the sets start, end
  /// and middle if they form one line; or bars along twines, with the data rest_length and parallel. The part
  /// also gets the sets of nodes of the mesh, limited to the nodes of its region.
  Geometry read(const ElementType& type, const std::string& name, std::size_t part,
                formats::TableReader& table);

  /// Joins parts at the nodes that they share in a mesh.
  void connect(Joiner& joiner) const;

  /// Whether some mesh could not be read. The number of nodes of its parts is then unknown.
  bool has_failed() const;

  const std::vector<formats::SourceFile>& files() const { return files_; }

 private:
  struct Standing {
    std::size_t part;
    const formats::InputMesh* mesh;
    std::vector<std::uint32_t> nodes;  // indexed by number within the part: number in the mesh
  };

  const formats::InputMesh* find_mesh(formats::TableReader& table);
  const formats::MeshRegion* find_region(const formats::InputMesh& mesh, formats::RegionKind kind,
                                         const std::string& name, formats::TableReader& table);

  std::filesystem::path folder_;
  formats::Diagnostics& diagnostics_;
  std::map<std::string, std::unique_ptr<formats::InputMesh>> meshes_;  // by name; nullptr after an error
  std::vector<Standing> standing_;
  std::vector<formats::SourceFile> files_;
};

}  // namespace netloft::scenes
