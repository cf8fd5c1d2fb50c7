// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/step_methods.hpp"

#include <algorithm>
#include <stdexcept>

namespace netloft::runs {

namespace {

// Smallest unit of work of a motion [operations]: one iteration with 1000 nodes, about 5 ms
constexpr double kLeastUnit = 1e8;

ParameterBlock block_of(std::span<const netloft_parameter> table, std::size_t bytes, const Values& values) {
  std::vector<std::string> faults;
  ParameterBlock block(table, bytes, values, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return block;
}

}  // namespace

ChosenStepMethods::ChosenStepMethods(const scenes::Dynamics& dynamics, const std::string& solver,
                                     const Values& parameters, Registry& registry)
    : integrator_(registry.integrator(dynamics.integrator)),
      solver_(registry.solver(solver)),
      integrator_parameters_(block_of(integrator_.parameters, integrator_.integrator.parameter_bytes,
                                      dynamics.integrator_parameters)),
      solver_parameters_(block_of(solver_.parameters, solver_.solver.parameter_bytes, parameters)) {}

WorkModel work_of_steps(const Assembler& assembler, const MakeFactorisation& make) {
  WorkModel model = make_work_model(assembler, make);
  model.unit = std::max(model.unit, kLeastUnit);
  return model;
}

}  // namespace netloft::runs
