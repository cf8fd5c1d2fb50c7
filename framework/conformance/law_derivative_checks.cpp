// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of a law are compared with central differences over a range of steps. For each flow, only the
// best step counts: large steps suffer from curvature, small ones from rounding.
#include "framework/conformance/law_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::conformance {

namespace {

constexpr double kLawKinkStep = 1e-6, kKinkLimit = 1e-3;
constexpr double kSlopeLimit = 1e-5;

/// Returns flows in which one array is changed by sign × step × field, with one step per flow.
Flows varied(const Flows& from, std::vector<double> Flows::*array, const std::vector<double>& field,
             const std::vector<double>& step, double sign) {
  Flows to = from;
  for (std::size_t i = 0; i < (to.*array).size(); ++i) (to.*array)[i] += sign * step[i % kLanes] * field[i];
  return to;
}

std::vector<double> steps(const LawBench& b, const Flows& f, double step) {
  std::vector<double> h(kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) h[lane] = step * b.reach(f, lane);
  return h;
}

double largest(const std::array<double, 3>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

/// Compares a derivative along a field of variations with the best central difference, relative to
/// LawBench::force_scale(). `promised(answer, lane, row)` is the law's derivative times the field.
template <class Promised>
void compare_slopes(LawBench& b, std::size_t part, std::vector<double> Flows::*array,
                    const std::vector<double>& field, bool by_speed, Promised&& promised, Worst& worst) {
  const Flows& f = b.tiles[part];
  const LawAnswer here = b.evaluate(part, f, true);
  const auto scale = b.force_scale(part, f);
  std::vector<double> best(kLanes, 1e300);
  for (const double step : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    const auto h = by_speed ? steps(b, f, step) : std::vector<double>(kLanes, step);
    const LawAnswer right = b.evaluate(part, varied(f, array, field, h, 1), false);
    const LawAnswer left = b.evaluate(part, varied(f, array, field, h, -1), false);
    for (std::size_t lane = 0; lane < f.count; ++lane) {
      std::array<double, 3> error;
      for (std::size_t row = 0; row < 3; ++row)
        error[row] = (right.force[at(row, lane)] - left.force[at(row, lane)]) / (2 * step) -
                     h[lane] / step * promised(here, lane, row);
      best[lane] = std::min(best[lane], ratio(largest(error), scale[lane]));
    }
  }
  for (std::size_t lane = 0; lane < f.count; ++lane)
    worst.note(best[lane], [&] { return b.place(part, lane); });
}

double along_field(const std::vector<double>& matrix, const std::vector<double>& field, std::size_t lane,
                   std::size_t row) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += matrix[at(3 * row + c, lane)] * field[at(c, lane)];
  return sum;
}

}  // namespace

/// Checks that the slopes on both sides of each flow agree, in particular for special flows (zero, parallel
/// or perpendicular to the twine).
Finding law_has_no_kink(LawBench& b) {
  Worst worst(kKinkLimit);
  for (std::size_t part = 0; part < b.tiles.size(); ++part)
    for (int k = 0; k < b.options.directions; ++k) {
      const Flows& f = b.tiles[part];
      const auto field = b.random_field(), h = steps(b, f, kLawKinkStep), scale = b.force_scale(part, f);
      const LawAnswer here = b.evaluate(part, f, false);
      const LawAnswer right = b.evaluate(part, varied(f, &Flows::flow, field, h, 1), false);
      const LawAnswer left = b.evaluate(part, varied(f, &Flows::flow, field, h, -1), false);
      for (std::size_t i = 0; i < here.force.size(); ++i)
        worst.note(
            ratio((right.force[i] - 2 * here.force[i] + left.force[i]) / kLawKinkStep, scale[i % kLanes]),
            [&] { return b.place(part, i % kLanes); });
    }
  return judged(worst, "");
}

Finding d_flow_is_derivative(LawBench& b) {
  Worst worst(kSlopeLimit);
  for (std::size_t part = 0; part < b.tiles.size(); ++part)
    for (int k = 0; k < b.options.directions; ++k) {
      const auto field = b.random_field();
      compare_slopes(
          b, part, &Flows::flow, field, true,
          [&](const LawAnswer& a, std::size_t lane, std::size_t row) {
            return along_field(a.d_flow, field, lane, row);
          },
          worst);
    }
  return judged(worst, "");
}

/// Directions are unit vectors. Therefore only their variations perpendicular to themselves are tested.
Finding d_direction_is_derivative(LawBench& b) {
  Worst worst(kSlopeLimit);
  for (std::size_t part = 0; part < b.tiles.size(); ++part)
    for (int k = 0; k < b.options.directions; ++k) {
      auto field = b.random_field();
      const auto& t = b.tiles[part].direction;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        double along = 0;
        for (std::size_t i = 0; i < 3; ++i) along += field[at(i, lane)] * t[at(i, lane)];
        for (std::size_t i = 0; i < 3; ++i) field[at(i, lane)] -= along * t[at(i, lane)];
      }
      compare_slopes(
          b, part, &Flows::direction, field, false,
          [&](const LawAnswer& a, std::size_t lane, std::size_t row) {
            return along_field(a.d_direction, field, lane, row);
          },
          worst);
    }
  return judged(worst, "");
}

Finding d_solidity_is_derivative(LawBench& b) {
  Worst worst(kSlopeLimit);
  const std::vector<double> one(kLanes, 1.0);
  for (std::size_t part = 0; part < b.tiles.size(); ++part)
    compare_slopes(
        b, part, &Flows::solidity, one, false,
        [](const LawAnswer& a, std::size_t lane, std::size_t row) { return a.d_solidity[at(row, lane)]; },
        worst);
  return judged(worst, "");
}

}  // namespace netloft::conformance
