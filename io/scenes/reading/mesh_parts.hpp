// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/toml/document.hpp"
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/joiner.hpp"

#include <filesystem>
#include <memory>

namespace netloft::scenes {

/// The geometry keys of a part on a region of a mesh from a file, which the program does not divide.
const std::vector<GeometryKey>& mesh_keys(Layout layout);

/// Reads parts whose elements come from mesh files, and joins the nodes that these parts have in common.
class MeshParts {
 public:
  /// Names of files are relative to `folder`, the folder of the scene.
  MeshParts(std::filesystem::path folder, formats::Diagnostics& diagnostics);

  /// Reads the region of a mesh that the part names; `part` is the index of the part in the scene. Elements
  /// on triangles take triangles, with the data u, v, bar_length and to_aft (meshes to the largest V of the
  /// region). Elements on bars take bars, with the data rest_length, and have the sets start, end and middle
  /// if the bars form one line. Panels in bars take bars of twines, with the data rest_length and parallel.
  /// The part gets those nodes of each set of the mesh that lie in its region.
  Geometry read(const ElementType& type, const std::string& name, std::size_t part,
                formats::TableReader& table);

  /// Joins the nodes of a mesh that several parts use.
  void connect(Joiner& joiner) const;

  /// Whether a mesh could not be read, so that the number of nodes of parts on it is unknown.
  bool has_failed() const;

  /// The files that were read.
  const std::vector<formats::SourceFile>& files() const { return files_; }

 private:
  struct Standing {
    std::size_t part;
    const formats::InputMesh* mesh;
    std::vector<std::uint32_t> nodes;  // nodes of the mesh, by own number
  };

  const formats::InputMesh* find_mesh(formats::TableReader& table);
  const formats::MeshRegion* find_region(const formats::InputMesh& mesh, formats::RegionKind kind,
                                         const std::string& name, formats::TableReader& table);

  std::filesystem::path folder_;
  formats::Diagnostics& diagnostics_;
  std::map<std::string, std::unique_ptr<formats::InputMesh>> meshes_;  // by name; null after an error
  std::vector<Standing> standing_;
  std::vector<formats::SourceFile> files_;
};

}  // namespace netloft::scenes
