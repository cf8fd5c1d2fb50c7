// SPDX-License-Identifier: BSD-3-Clause
#include "io/report/run_result.hpp"

#include "io/scene/result_request.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

void collect_part_forces(const LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    std::vector<double> sums(3 * family.parts().size());
    for (std::size_t t = 0; t < family.active_terms().size(); ++t) {
      if (!assembler.sum_term(result.solution.x, f, t, sums)) continue;
      for (std::size_t p = 0; p < family.parts().size(); ++p)
        result.part_forces.push_back({loaded.scene.parts[family.parts()[p]].name,
                                      family.active_terms()[t].name,
                                      {0.0 - sums[3 * p], 0.0 - sums[3 * p + 1], 0.0 - sums[3 * p + 2]}});
    }
  }
}

void collect_hold_forces(const LoadedScene& loaded, const Assembler& assembler, RunResult& result) {
  for (const auto& hold : loaded.holds) {
    HoldForce sum{hold.name, {}};
    for (std::size_t i = 0; i < hold.nodes.size(); ++i) {
      const auto force = assembler.reaction(hold.nodes[i], result.solution.residual, hold.axes[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) sum.force[axis] += force[axis];
    }
    result.hold_forces.push_back(sum);
  }
}

void add_to_balance(const std::array<double, 3>& force, RunResult& result) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.balance[axis] += force[axis];
    result.largest_force = std::max(result.largest_force, std::abs(force[axis]));
  }
}

void collect_balance(RunResult& result) {
  for (const auto& f : result.part_forces) add_to_balance(f.force, result);
  for (const auto& h : result.hold_forces) add_to_balance(h.force, result);
}

void collect_outputs(Assembler& assembler, const Solution& solution,
                     std::vector<std::vector<std::vector<double>>>& outputs) {
  outputs.resize(assembler.families().size());
  for (std::size_t f = 0; f < outputs.size(); ++f) assembler.outputs(solution.x, f, outputs[f]);
}

/// What every scalar would be after the step that is left: one evaluation more. No scalar is known better
/// than to its last digit.
void collect_solver_errors(const LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  Solution after;
  after.x = result.solution.corrected;
  after.residual.resize(after.x.size());
  if (after.x.empty() || !assembler.evaluate(after.x, {.residual = after.residual.data()})) return;
  std::vector<std::vector<std::vector<double>>> outputs;
  collect_outputs(assembler, after, outputs);
  for (std::size_t i = 0; i < result.scalars.size(); ++i) {
    NamedScalar& scalar = result.scalars[i];
    const double moved = value_of(loaded.results[i], loaded.scene, assembler, after, outputs);
    const double last_digit = std::numeric_limits<double>::epsilon() * std::abs(scalar.value);
    scalar.solver_error = std::max(last_digit, std::abs(moved - scalar.value));
  }
}

}  // namespace

void collect(const LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  collect_outputs(assembler, result.solution, result.outputs);
  collect_part_forces(loaded, assembler, result);
  collect_hold_forces(loaded, assembler, result);
  collect_balance(result);
  for (const auto& request : loaded.results)
    result.scalars.push_back({request.name, request.unit, request.take + " of " + request.of,
                              value_of(request, loaded.scene, assembler, result.solution, result.outputs)});
  collect_solver_errors(loaded, assembler, result);
}

}  // namespace netloft::io
