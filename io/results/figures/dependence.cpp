// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/dependence.hpp"

#include "framework/judging/correction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace netloft::results {

namespace {

/// Sets the solver error of every number: its distance to `after`, the value after the next Newton step, but
/// at least the rounding unit.
void note_changes(const std::vector<NamedScalar>& after, std::vector<NamedScalar>& scalars) {
  for (auto& scalar : scalars) {
    const NamedScalar* moved = find_scalar(after, scalar.name);
    const double last_digit = std::numeric_limits<double>::epsilon() * std::abs(scalar.value);
    if (moved) scalar.solver_error = std::max(std::abs(moved->value - scalar.value), last_digit);
  }
}

/// Widens the range of every number to include its value at another equilibrium.
void widen(const std::vector<NamedScalar>& there, std::vector<NamedScalar>& scalars) {
  for (auto& scalar : scalars) {
    const NamedScalar* other = find_scalar(there, scalar.name);
    if (!other) continue;
    scalar.least = std::fmin(std::fmin(scalar.least, scalar.value), other->value);
    scalar.largest = std::fmax(std::fmax(scalar.largest, scalar.value), other->value);
  }
}

/// Estimates the solver error: evaluates all numbers once more, after another Newton step.
void add_solver_errors(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution,
                       Result& result) {
  Solution after;
  after.x = solution.correction.x;
  after.x_low = solution.correction.x_low;
  if (const auto numbers = numbers_at(loaded, assembler, std::move(after))) {
    note_changes(numbers->scalars, result.scalars);
    note_changes(numbers->figures, result.figures);
  }
}

/// Widens the range of all numbers by their values at every other equilibrium that was found.
void add_spread(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution,
                Result& result) {
  for (const OtherShape& other : solution.shapes.others) {
    Solution there;
    there.x = other.x;
    there.energy = other.energy;
    if (const auto numbers = numbers_at(loaded, assembler, std::move(there))) {
      widen(numbers->scalars, result.scalars);
      widen(numbers->figures, result.figures);
    }
  }
}

// Step of the central differences: the largest nodal displacement along a growing motion, as a fraction of
// the length of the gear. The step is so small that numbers change linearly, but large compared with
// round-off.
constexpr double kSmallSwing = 1e-6;

double length_of(std::span<const double> x) {
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  return *most - *least;
}

/// The solution after a displacement of the unknowns by `length` times the mode `along`.
Solution swung(const Assembler& assembler, const Solution& s, const std::vector<double>& along,
               double length) {
  Solution there;
  there.u = s.u;
  there.x = s.x;
  there.energy = s.energy;
  for (std::size_t i = 0; i < there.u.size(); ++i) there.u[i] += length * along[i];
  assembler.place(there.u, there.x);
  return there;
}

/// Combines the change of every number along one mode of a growing motion with `per_swing`, as the root of
/// the sum of squares. An oscillation has two modes, a quarter of a period apart; after both modes,
/// `per_swing` is the amplitude. `way` is the distance between the two displaced positions of the node that
/// moves most [m].
void note_swing(const std::vector<NamedScalar>& to_one_side, const std::vector<NamedScalar>& to_the_other,
                double way, std::vector<NamedScalar>& scalars) {
  for (auto& scalar : scalars) {
    const NamedScalar *a = find_scalar(to_one_side, scalar.name), *b = find_scalar(to_the_other, scalar.name);
    if (!a || !b) continue;
    const double before = std::isfinite(scalar.per_swing) ? scalar.per_swing : 0;
    scalar.per_swing = std::hypot(before, std::abs(a->value - b->value) / way);
  }
}

/// Finds how much the numbers of an equilibrium change along its growing motion, by central differences.
void add_swing(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& s, Result& result) {
  if (s.growing.mode.empty() || s.growing.mode.size() != s.u.size()) return;
  const double length = kSmallSwing * length_of(s.x);
  double way = 0;  // distance between the displaced positions of the node that moves most, first mode [m]
  for (const auto* along : {&s.growing.mode, &s.growing.mode_later}) {
    if (along->size() != s.u.size()) continue;
    const Solution one = swung(assembler, s, *along, length), other = swung(assembler, s, *along, -length);
    if (way == 0) {
      const NodeDistance furthest = furthest_node(loaded.scene, assembler.numbering(), one.x, other.x);
      way = furthest.distance;
      if (way > 0)
        result.swing = Swing{assembler.node_name(loaded.scene, furthest.node), s.growing.rate,
                             s.growing.frequency, s.growing.share};
    }
    const auto at_one = numbers_at(loaded, assembler, one), at_other = numbers_at(loaded, assembler, other);
    if (!(way > 0) || !at_one || !at_other) return;
    note_swing(at_one->scalars, at_other->scalars, way, result.scalars);
    note_swing(at_one->figures, at_other->figures, way, result.figures);
  }
}

}  // namespace

void add_dependence(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution,
                    Result& result) {
  add_solver_errors(loaded, assembler, solution, result);
  add_spread(loaded, assembler, solution, result);
  add_swing(loaded, assembler, solution, result);
}

}  // namespace netloft::results
