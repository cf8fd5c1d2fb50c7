// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/registry.hpp"
#include "io/scenes/reading/analysis.hpp"

namespace netloft::runs {

/// The integrator of an analysis and the solver for its implicit steps. Their parameters are in the layout
/// that plugins read.
class ChosenStepMethods {
 public:
  /// Throws std::invalid_argument if a plugin rejects parameters; the parameters of a scene were checked when
  /// the scene was read.
  ChosenStepMethods(const scenes::Dynamics& dynamics, const std::string& solver, const Values& parameters,
                    Registry& registry);

  StepMethods methods() const {
    return {{&integrator_, integrator_parameters_.data()}, {&solver_, solver_parameters_.data()}};
  }

 private:
  const IntegratorType& integrator_;
  const SolverType& solver_;
  ParameterBlock integrator_parameters_, solver_parameters_;
};

/// Returns a model that counts the work of time steps. Its unit is one Newton iteration of the scene; for
/// scenes with fewer than 1000 nodes, an iteration of a scene with 1000 nodes, because small scenes take many
/// cheap steps.
WorkModel work_of_steps(const Assembler& assembler, const MakeFactorisation& make);

}  // namespace netloft::runs
