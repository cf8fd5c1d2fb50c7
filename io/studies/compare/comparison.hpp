// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/discretisation.hpp"
#include "io/studies/compare/reference_path.hpp"

#include <map>

namespace netloft::studies {

/// The methods, tolerances and meshes that a comparison runs.
struct ComparisonTask {
  bool is_of_motions = false;      // true: the methods are integrators
  std::vector<Method> methods;     // at least one method
  std::vector<double> tolerances;  // decreasing; for integrators, these are accuracies
  int repeats = 3;                 // number of runs of each trial, of which the cheapest counts
  std::string reference;           // solver or integrator for references; empty: any except the tested one
  std::optional<CellList> cells;   // meshes for the discretisation error
  // Requested integrators whose plugins are not installed, each with a sentence that says so.
  std::map<std::string, std::string> absent;
};

/// The difference between a method's answer and the reference answer, if they are two different equilibria.
struct OtherEquilibrium {
  double distance = 0;           // largest distance of a node [m]
  double energy_difference = 0;  // energy of the method's answer minus that of the reference [J]
  bool has_energy = false;       // false: not all forces have a potential
};

/// One method at every tolerance, with the reference from which its errors are measured.
struct MethodResult {
  Method method;
  std::vector<Trial> trials;
  std::optional<ReferenceAnswer> reference;  // nullopt: no other solver converged
  // If set, method and reference found different equilibria, and the trials have no errors.
  std::optional<OtherEquilibrium> other;
  bool is_absent = false;  // whether the plugin is not installed; the only trial then says so
};

/// Speed against error of several methods on one scene.
struct Comparison {
  bool is_of_motions = false;
  std::string scene, mesh;  // `mesh`: such as "32 x 32 cells of net"
  std::size_t unknowns = 0;
  double factorisation_seconds = 0;  // processor time of one factorisation of the tangent
  int repeats = 1;
  double size = 0;  // diagonal of the gear's bounding box [m]
  std::vector<MethodResult> methods;
  std::optional<Discretisation> discretisation;
  bool is_interrupted = false;  // whether the user interrupted; some methods and steps are then missing

  bool any_converged() const;
  bool any_failed() const;  // whether a plugin broke down in a trial
};

/// Runs all trials. The caller must have opened the scene with every method before, and reported the errors.
/// Throws std::runtime_error if a scene still has errors, std::invalid_argument if its parts cannot be
/// divided into `task.cells`.
Comparison compare(const runs::CaseSource& source, Registry& registry, const ComparisonTask& task,
                   const runs::Watch& watch);

}  // namespace netloft::studies
