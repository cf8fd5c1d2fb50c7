// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/studies/optimum/optimum_file.hpp"
#include "solvers/fitting/optimum/optimum.hpp"

#include <functional>
#include <memory>

namespace netloft::studies {

/// A file for `netloft optimise` that was checked against its scene.
struct CheckedOptimum {
  OptimumProblem problem;  // in the units of the variables and the figures
  std::vector<std::string> figures,
      units;                    // objective and constraints: their figures, and the units of these
  double objective_factor = 1;  // factor from the unit of the objective's figure to the unit in the file
  std::string inputs;           // hash of all inputs of the figures at a point
  bool refused = false;         // whether a plugin is missing or was rejected
  std::shared_ptr<runs::PreparedScene> scene;  // the scene at its own numbers
};

/// Opens the scene at its own numbers, and with each variable at its start, a little beside its start, and at
/// both ends of its range. Reports errors in the file: wrong keys, values, figures and units, and variables
/// that cannot change continuously because the mesh changes with them. `on_budget` receives the processor
/// time allowed for the figures of the scene [s].
CheckedOptimum check_optimum(const OptimumFile& file, const std::filesystem::path& folder, Registry& registry,
                             formats::Diagnostics& diagnostics,
                             const std::function<void(double)>& on_budget = {});

}  // namespace netloft::studies
