// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/registry.hpp"
#include "io/scenes/reading/analysis.hpp"

namespace netloft::runs {

/// The integrator of an analysis and a solver for its implicit steps, with their parameters in the layout
/// that plugins read.
class ChosenStepMethods {
 public:
  /// Throws std::invalid_argument for parameters that a plugin rejects; those of a scene were checked before.
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

/// Measures the work of steps in Newton iterations of the scene, or of a scene with 1000 nodes if that is
/// larger, because small scenes take many cheap steps.
WorkModel work_of_steps(const Assembler& assembler, const MakeFactorisation& make);

}  // namespace netloft::runs
