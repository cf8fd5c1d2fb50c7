// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/compare/numbers_on_mesh.hpp"

namespace netloft::io {

/// What a scene reports on finer and finer meshes.
struct Refinement {
  std::string scene;
  std::vector<NumbersOnMesh> meshes;  // from the coarsest to the finest
  std::vector<std::string> missing;   // sentences about meshes that gave no answer
};

/// One number on all meshes, and what it tends to.
struct RefinedNumber {
  std::string name, unit;      // "results/lowest_z", "gear/mouth/area", as in result files
  std::vector<double> values;  // per mesh
  Trend trend;                 // its error is that of the finest mesh

  /// By more than round-off.
  bool varies() const;
};

/// Solves the scene on every mesh; what does not converge is left out, and said.
Refinement refine(const CaseSource& source, Registry& registry, const std::vector<MeshLevel>& levels,
                  const Watch& watch);

/// Named results, then figures of the gear, in the order in which the finest mesh reports them. Fewer than
/// two meshes: nothing.
std::vector<RefinedNumber> find_trends(const Refinement& refinement);

/// A line per number that varies with the mesh, but for figures by part; and as one JSON object, with all.
std::string refinement_text(const Refinement& refinement);
std::string refinement_json(const Refinement& refinement);

}  // namespace netloft::io
