// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

constexpr const char* kIsNoFlow = "it is not a flow";
constexpr double kTurnOfCurrent = 0.7;     // rotation of the current [rad]
constexpr double kRoundingOfTurn = 1e-12;  // rounding of a rotation
constexpr double kWaterStep = 1e-6;        // step of central differences, in m/s or in units of the unknowns
constexpr double kWaterLimit = 1e-6;       // error of these differences, for a derivative of the order of 1

/// Input of a flow for 64 places, and its output.
struct WaterOfFlow {
  explicit WaterOfFlow(const Bench& b, const States& s) : unknown_count(b.type.globals.size()) {
    const std::size_t last = b.dofs() - 3;
    for (std::size_t k = 0; k < unknown_count; ++k)
      std::copy_n(&s.x[at(last + k, 0)], kLanes, &unknowns[at(k, 0)]);
    std::copy_n(s.current.begin(), 3 * kLanes, current);
    for (std::size_t lane = 0; lane < kLanes; ++lane) put_normal(lane);
  }
  /// Sets the reach and the normal of a place. The last place is on a rope, which has no normal.
  void put_normal(std::size_t lane) {
    const double share = static_cast<double>(lane + 1) / static_cast<double>(kLanes);
    reach[lane] = share;
    if (lane + 1 == kLanes) return;
    normal[at(0, lane)] = std::cos(7 * share) * std::sin(3 * share);
    normal[at(1, lane)] = std::sin(7 * share) * std::sin(3 * share);
    normal[at(2, lane)] = std::cos(3 * share);
  }
  bool ask(const Bench& b) {
    netloft_flow_tile t{};
    t.size = sizeof t;
    t.count = kLanes;
    t.unknowns = unknowns;
    t.current = current;
    t.reach = reach;
    t.velocity = velocity;
    t.d_current = d_current;
    t.d_unknown = d_unknown;
    t.weight = weight;
    t.d_weight = d_weight;
    t.normal = normal;
    t.d_normal = d_normal;
    return b.specimen->find_water(t) == NETLOFT_OK;
  }
  std::size_t unknown_count;
  double unknowns[3 * kLanes] = {}, current[3 * kLanes] = {}, normal[3 * kLanes] = {}, reach[kLanes] = {};
  double velocity[3 * kLanes] = {}, d_current[9 * kLanes] = {}, d_unknown[9 * kLanes] = {},
                      weight[9 * kLanes] = {}, d_weight[27 * kLanes] = {}, d_normal[9 * kLanes] = {};
};

/// Rotates rows of vectors about z.
void turn_rows(double* rows) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double x = rows[at(0, lane)], y = rows[at(1, lane)];
    rows[at(0, lane)] = std::cos(kTurnOfCurrent) * x - std::sin(kTurnOfCurrent) * y;
    rows[at(1, lane)] = std::sin(kTurnOfCurrent) * x + std::cos(kTurnOfCurrent) * y;
  }
}

/// The output of the flow after a change of one row of its input by `step`.
WaterOfFlow stepped(const Bench& b, WaterOfFlow water, double (WaterOfFlow::*inputs)[3 * kLanes],
                    std::size_t row, double step) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) (water.*inputs)[at(row, lane)] += step;
  water.ask(b);
  return water;
}

/// Calls visit(water) for each sampled tile, after the flow has computed the water there.
template <class Visit>
Finding visit_water(Bench& b, double limit, const Visit& visit) {
  if (!b.type.is_flow()) return not_applicable(kIsNoFlow);
  Worst worst(limit);
  for (const auto& tile : b.tiles) {
    WaterOfFlow water(b, tile);
    if (!water.ask(b)) return failed("the flow refuses to give the velocity of the water");
    visit(water, worst);
  }
  return judged(worst, kIsNoFlow);
}

std::string lane_place(std::size_t lane) { return "at a place of reach " + std::to_string(lane + 1) + "/64"; }

}  // namespace

Finding water_is_undisturbed_out_of_reach(Bench& b) {
  return visit_water(b, kRoundingOfTurn, [&](WaterOfFlow water, Worst& worst) {
    std::fill(std::begin(water.reach), std::end(water.reach), 0.0);
    water.ask(b);
    for (std::size_t i = 0; i < 3 * kLanes; ++i)
      worst.note(std::abs(water.velocity[i] - water.current[i]), [] { return "at a place of reach 0"; });
  });
}

Finding water_has_its_derivatives(Bench& b) {
  return visit_water(b, kWaterLimit, [&](const WaterOfFlow& water, Worst& worst) {
    // Component r of the derivative of a vector is in row r * stride of `derivative`.
    const auto compare = [&](const double* after, const double* before, const double* derivative,
                             std::size_t stride) {
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          worst.note(std::abs((after[at(r, lane)] - before[at(r, lane)]) / (2 * kWaterStep) -
                              derivative[at(r * stride, lane)]),
                     [&] { return lane_place(lane); });
    };
    for (std::size_t c = 0; c < 3; ++c) {
      const WaterOfFlow after = stepped(b, water, &WaterOfFlow::current, c, kWaterStep),
                        before = stepped(b, water, &WaterOfFlow::current, c, -kWaterStep);
      compare(after.velocity, before.velocity, &water.d_current[at(c, 0)], 3);
      for (std::size_t k = 0; k < water.unknown_count; ++k)
        compare(&after.weight[at(3 * k, 0)], &before.weight[at(3 * k, 0)], &water.d_weight[at(9 * k + c, 0)],
                3);
      compare(stepped(b, water, &WaterOfFlow::normal, c, kWaterStep).velocity,
              stepped(b, water, &WaterOfFlow::normal, c, -kWaterStep).velocity, &water.d_normal[at(c, 0)], 3);
    }
    for (std::size_t k = 0; k < water.unknown_count; ++k)
      compare(stepped(b, water, &WaterOfFlow::unknowns, k, kWaterStep).velocity,
              stepped(b, water, &WaterOfFlow::unknowns, k, -kWaterStep).velocity,
              &water.d_unknown[at(3 * k, 0)], 1);
  });
}

Finding water_turns_with_the_current(Bench& b) {
  return visit_water(b, kRoundingOfTurn, [&](const WaterOfFlow& water, Worst& worst) {
    WaterOfFlow turned = water, expected = water;
    turn_rows(turned.current);
    turn_rows(turned.normal);
    for (double& component : turned.normal) component = -component;  // the sign of a normal has no meaning
    turned.ask(b);
    turn_rows(expected.velocity);
    for (std::size_t k = 0; k < water.unknown_count; ++k) turn_rows(&expected.weight[at(3 * k, 0)]);
    for (std::size_t i = 0; i < 3 * kLanes; ++i)
      worst.note(std::abs(turned.velocity[i] - expected.velocity[i]),
                 [&] { return "velocity " + lane_place(i % kLanes); });
    for (std::size_t i = 0; i < 3 * water.unknown_count * kLanes; ++i)
      worst.note(std::abs(turned.weight[i] - expected.weight[i]),
                 [&] { return "weight " + lane_place(i % kLanes); });
  });
}

}  // namespace netloft::conformance
