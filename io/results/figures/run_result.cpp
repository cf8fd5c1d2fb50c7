// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/run_result.hpp"

#include "framework/assembler/reports.hpp"
#include "framework/judging/correction.hpp"
#include "io/results/figures/fallen_boards.hpp"
#include "io/results/figures/overload.hpp"

#include "io/results/figures/gear_figures.hpp"
#include "io/results/figures/law_range.hpp"
#include "io/results/figures/whereabouts.hpp"
#include "io/scenes/reading/result_request.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace netloft::results {

namespace {

void collect_hold_forces(const scenes::LoadedScene& loaded, const Assembler& assembler, RunResult& result) {
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

std::vector<NamedScalar> collect_scalars(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                         const Solution& solution, const FamilyOutputs& outputs) {
  std::vector<NamedScalar> scalars;
  for (const auto& request : loaded.results)
    scalars.push_back({request.name, request.unit, request.take + " of " + request.of,
                       scenes::value_of(request, loaded, assembler, solution, outputs)});
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

/// Widens what is known of a number by its value at another equilibrium; unknown ends are those of one.
void widen(const std::vector<NamedScalar>& there, std::vector<NamedScalar>& scalars) {
  for (auto& scalar : scalars) {
    const NamedScalar* other = find_scalar(there, scalar.name);
    if (!other) continue;
    scalar.least = std::fmin(std::fmin(scalar.least, scalar.value), other->value);
    scalar.largest = std::fmax(std::fmax(scalar.largest, scalar.value), other->value);
  }
}

/// The motion of a scene at rest, with the low-order part of its positions if that is known.
Kinematics at_rest(const Solution& s) { return {.x_low = s.x_low.empty() ? nullptr : s.x_low.data()}; }

/// All numbers of a scene at one place.
struct Numbers {
  std::vector<NamedScalar> scalars, gear;
};

/// Empty where there is no place, or no force there.
std::optional<Numbers> numbers_at(const scenes::LoadedScene& loaded, Assembler& assembler, Solution there) {
  there.residual.assign(there.x.size(), 0.0);
  const Kinematics motion = at_rest(there);
  if (there.x.empty() || !assembler.evaluate(there.x, {.residual = there.residual.data(), .motion = motion}))
    return {};
  const Response answer = ask_elements(loaded.scene, assembler, there.x, motion);
  return Numbers{collect_scalars(loaded, assembler, there, answer.outputs),
                 collect_gear(loaded, assembler, answer)};
}

/// Evaluates all numbers once more, after the next Newton step, to estimate the solver's error.
void collect_solver_errors(const scenes::LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  Solution after;
  after.x = result.solution.correction.x;
  after.x_low = result.solution.correction.x_low;
  if (const auto numbers = numbers_at(loaded, assembler, std::move(after))) {
    note_changes(numbers->scalars, result.scalars);
    note_changes(numbers->gear, result.gear);
  }
}

/// And at every other equilibrium that was found.
void collect_spread(const scenes::LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  for (const OtherShape& other : result.solution.shapes.others) {
    Solution there;
    there.x = other.x;
    there.energy = other.energy;
    if (const auto numbers = numbers_at(loaded, assembler, std::move(there))) {
      widen(numbers->scalars, result.scalars);
      widen(numbers->gear, result.gear);
    }
  }
}

// How far the furthest node of what grows is moved to see what depends on it, over the gear's length: small
// against what bends, large against what a double rounds off.
constexpr double kSmallSwing = 1e-6;

double length_of(std::span<const double> x) {
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  return *most - *least;
}

/// The solution displaced along a part of what grows.
Solution swung(const Assembler& assembler, const Solution& s, const std::vector<double>& along,
               double length) {
  Solution there;
  there.u = s.u;
  there.x.resize(s.x.size());
  there.energy = s.energy;
  for (std::size_t i = 0; i < there.u.size(); ++i) there.u[i] += length * along[i];
  assembler.place(there.u, there.x);
  return there;
}

/// Adds what two phases of a swing, a quarter of a period apart, change: as both are largest in turn.
void note_swing(const std::vector<NamedScalar>& to_one_side, const std::vector<NamedScalar>& to_the_other,
                double way, std::vector<NamedScalar>& scalars) {
  for (auto& scalar : scalars) {
    const NamedScalar *a = find_scalar(to_one_side, scalar.name), *b = find_scalar(to_the_other, scalar.name);
    if (!a || !b) continue;
    const double before = std::isfinite(scalar.per_swing) ? scalar.per_swing : 0;
    scalar.per_swing = std::hypot(before, std::abs(a->value - b->value) / way);
  }
}

/// How much the numbers of an equilibrium depend on what grows there, by central differences.
void collect_swing(const scenes::LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  const Solution& s = result.solution;
  const bool grows = s.stability == Stability::swinging || s.stability == Stability::unstable;
  if (!grows || s.growing.mode.size() != s.u.size()) return;
  const double length = kSmallSwing * length_of(s.x);
  double way = 0;  // of the furthest node, in the first phase
  for (const auto* along : {&s.growing.mode, &s.growing.mode_later}) {
    if (along->size() != s.u.size()) continue;
    const Solution one = swung(assembler, s, *along, length), other = swung(assembler, s, *along, -length);
    if (way == 0) {
      const NodeDistance furthest = furthest_node(loaded.scene, assembler.numbering(), one.x, other.x);
      way = furthest.distance;
      if (way > 0) result.swings_most = assembler.node_name(loaded.scene, furthest.node);
    }
    const auto at_one = numbers_at(loaded, assembler, one), at_other = numbers_at(loaded, assembler, other);
    if (!(way > 0) || !at_one || !at_other) return;
    note_swing(at_one->scalars, at_other->scalars, way, result.scalars);
    note_swing(at_one->gear, at_other->gear, way, result.gear);
  }
}

}  // namespace

const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name) {
  const auto at =
      std::find_if(scalars.begin(), scalars.end(), [&](const NamedScalar& s) { return s.name == name; });
  return at == scalars.end() ? nullptr : &*at;
}

std::vector<NamedScalar> collect_gear(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer) {
  std::vector<NamedScalar> gear;
  for (auto& figure : find_gear_figures(loaded, assembler, answer))
    gear.push_back({figure.name, figure.unit, figure.doc, figure.value});
  return gear;
}

void collect(const scenes::LoadedScene& loaded, Assembler& assembler, RunResult& result) {
  Response answer = ask_elements(loaded.scene, assembler, result.solution.x, at_rest(result.solution));
  result.scalars = collect_scalars(loaded, assembler, result.solution, answer.outputs);
  result.gear = collect_gear(loaded, assembler, answer);
  result.ropes = find_rope_tensions(loaded, assembler, answer);
  result.warnings = overload_warnings(loaded, assembler, answer);
  result.law_use = assembler.reports().find_law_use(result.solution.x, at_rest(result.solution));
  for (auto& sentence : law_range_warnings(loaded.scene, result.law_use))
    result.warnings.push_back(std::move(sentence));
  for (auto& doubt : doubt_warnings(loaded, assembler, answer)) result.warnings.push_back(std::move(doubt));
  for (auto& place : whereabouts_warnings(loaded, assembler, answer))
    result.warnings.push_back(std::move(place));
  for (auto& board : find_fallen_boards(loaded, result.gear))
    result.warnings.push_back(std::move(board.sentence));
  result.outputs = std::move(answer.outputs);
  result.part_forces = std::move(answer.forces);
  collect_hold_forces(loaded, assembler, result);
  collect_balance(result);
  collect_solver_errors(loaded, assembler, result);
  collect_spread(loaded, assembler, result);
  collect_swing(loaded, assembler, result);
}

}  // namespace netloft::results
