// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/numbers_on_mesh.hpp"

namespace netloft::studies {

/// The numbers that a scene reports on successively finer meshes.
struct Refinement {
  std::string scene;
  std::vector<NumbersOnMesh> meshes;  // meshes, the coarsest first
  std::vector<std::string> missing;   // sentences about meshes without an answer
  bool is_interrupted = false;  // whether the user interrupted; the current and finer meshes are then missing
};

/// One number on all meshes, and its limit.
struct RefinedNumber {
  std::string name, unit;      // "results/lowest_z", "gear/mouth/area", as in result files
  std::vector<double> values;  // one value for each mesh
  Trend trend;                 // trend.error is the error on the finest mesh

  /// Whether the values differ by more than round-off.
  bool varies() const;
  /// Whether the number is a tension at a rope end that has no limit; it then has no error.
  bool diverges() const;
};

/// Solves the scene on every mesh. A mesh without an equilibrium is left out; `missing` gets a sentence about
/// it.
Refinement refine(const runs::CaseSource& source, Registry& registry, const std::vector<MeshLevel>& levels,
                  const runs::Watch& watch);

/// The trends of the numbers in [results], then of the figures of the gear, both in the order of the report
/// on the finest mesh. Empty for fewer than two meshes.
std::vector<RefinedNumber> find_trends(const Refinement& refinement);

/// refinement_text() has a line for every number that varies with the mesh, except figures of single parts;
/// refinement_json() is one JSON object with all numbers.
std::string refinement_text(const Refinement& refinement);
std::string refinement_json(const Refinement& refinement);

}  // namespace netloft::studies
