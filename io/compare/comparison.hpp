// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/compare/discretisation.hpp"
#include "io/compare/reference.hpp"

namespace netloft::io {

/// What is compared.
struct ComparisonTask {
  std::vector<Method> methods;     // at least one
  std::vector<double> tolerances;  // falling
  int repeats = 3;                 // of every trial; the cheapest counts
  std::string reference;           // solver that references are asked of; empty: another one than the method
  std::optional<CellList> cells;   // meshes for the discretisation error
};

/// A method that came to rest elsewhere than its reference.
struct OtherEquilibrium {
  double distance = 0;           // largest of a node [m]
  double energy_difference = 0;  // its energy less that of the reference [J]
  bool has_energy = false;       // false: not all forces have one
};

/// A method at every tolerance, and what it was judged by.
struct MethodResult {
  Method method;
  std::vector<Trial> trials;
  std::optional<ReferenceAnswer> reference;  // nothing: no other solver arrived
  std::optional<OtherEquilibrium> other;     // then distances are no errors, and trials have none
};

/// Speed against error of several methods on one scene.
struct Comparison {
  std::string scene, mesh;  // "32 x 32 cells of net"
  std::size_t unknowns = 0;
  double factorisation_seconds = 0;  // of the processor, one numeric factorisation of the same tangent
  int repeats = 1;
  double size = 0;  // of the gear, corner to corner [m]
  std::vector<MethodResult> methods;
  std::optional<Discretisation> discretisation;

  bool any_arrived() const;
};

/// Runs everything. The scene must have been opened with every method before, so that it is known to be
/// sound; throws std::runtime_error when it is not, std::invalid_argument for divisions that it does not
/// have.
Comparison compare(const CaseSource& source, Registry& registry, const ComparisonTask& task,
                   const Watch& watch);

}  // namespace netloft::io
