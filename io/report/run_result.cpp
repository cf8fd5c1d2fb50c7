// SPDX-License-Identifier: BSD-3-Clause
#include "io/report/run_result.hpp"

#include "io/report/overload.hpp"

#include "io/report/gear_figures.hpp"
#include "io/report/law_range.hpp"
#include "io/scene/result_request.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

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

std::vector<NamedScalar> collect_scalars(const LoadedScene& loaded, const Assembler& assembler,
                                         const Solution& solution, const FamilyOutputs& outputs) {
  std::vector<NamedScalar> scalars;
  for (const auto& request : loaded.results)
    scalars.push_back({request.name, request.unit, request.take + " of " + request.of,
                       value_of(request, loaded, assembler, solution, outputs)});
  return scalars;
}

/// Sets the solver error of every number: its difference from the number after the next Newton step, and at
/// least its rounding unit.
void note_changes(const std::vector<NamedScalar>& after, std::vector<NamedScalar>& scalars) {
  for (auto& scalar : scalars) {
    const NamedScalar* moved = find_scalar(after, scalar.name);
    const double last_digit = std::numeric_limits<double>::epsilon() * std::abs(scalar.value);
    if (moved) scalar.solver_error = std::max(std::abs(moved->value - scalar.value), last_digit);
  }
}

/// The motion of a scene at rest, with the low-order part of its positions if that is known.
Kinematics at_rest(const Solution& s) { return {.x_low = s.x_low.empty() ? nullptr : s.x_low.data()}; }

/// Evaluates all numbers once more, after the next Newton step, to estimate the solver's error.
void collect_solver_errors(const LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  Solution after;
  after.x = result.solution.corrected, after.x_low = result.solution.corrected_low;
  after.residual.resize(after.x.size());
  const Kinematics at_corrected = at_rest(after);
  if (after.x.empty() ||
      !assembler.evaluate(after.x, {.residual = after.residual.data(), .motion = at_corrected}))
    return;
  const Answer answer = ask_elements(loaded.scene, assembler, after.x, at_corrected);
  note_changes(collect_scalars(loaded, assembler, after, answer.outputs), result.scalars);
  note_changes(collect_gear(loaded, assembler, answer), result.gear);
}

}  // namespace

const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name) {
  const auto at =
      std::find_if(scalars.begin(), scalars.end(), [&](const NamedScalar& s) { return s.name == name; });
  return at == scalars.end() ? nullptr : &*at;
}

std::vector<NamedScalar> collect_gear(const LoadedScene& loaded, const Assembler& assembler,
                                      const Answer& answer) {
  std::vector<NamedScalar> gear;
  for (auto& figure : find_gear_figures(loaded, assembler, answer))
    gear.push_back({figure.name, figure.unit, figure.doc, figure.value});
  return gear;
}

void collect(const LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  Answer answer = ask_elements(loaded.scene, assembler, result.solution.x, at_rest(result.solution));
  result.scalars = collect_scalars(loaded, assembler, result.solution, answer.outputs);
  result.gear = collect_gear(loaded, assembler, answer);
  result.ropes = find_rope_tensions(loaded, assembler, answer);
  result.warnings = overload_warnings(loaded, assembler, answer);
  result.law_use = assembler.find_law_use(result.solution.x, at_rest(result.solution));
  for (auto& sentence : law_range_warnings(loaded.scene, result.law_use))
    result.warnings.push_back(std::move(sentence));
  for (auto& doubt : doubt_warnings(loaded, assembler, answer)) result.warnings.push_back(std::move(doubt));
  result.outputs = std::move(answer.outputs), result.part_forces = std::move(answer.forces);
  collect_hold_forces(loaded, assembler, result);
  collect_balance(result);
  collect_solver_errors(loaded, assembler, result);
}

}  // namespace netloft::io
