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
constexpr double kDensity = 1025;          // of the water of a specimen [kg/m3]
constexpr double kSpeedOfMouth = 1.5;      // current through a mouth [m/s]
constexpr double kSlight = 1e-3;  // drag over the dynamic pressure of the mouth: neglected terms are as large
constexpr double kSlightLimit = 10 * kSlight;
constexpr double kInducedOfMouth = 0.3;  // unknown of the flow at which the mouths are compared
constexpr double kFrameLimit = 1e-10;    // sums of some ten numbers of either sign

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
  /// The water in full reach on netting across a current along x.
  WaterOfFlow(const Bench& b, double unknown) : unknown_count(b.type.globals.size()) {
    std::fill(std::begin(unknowns), std::end(unknowns), unknown);
    std::fill_n(current, kLanes, kSpeedOfMouth);
    std::fill_n(normal, kLanes, 1.0);
    std::fill(std::begin(reach), std::end(reach), 1.0);
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

/// A square mouth of 2 m by 2 m across a current. Its rim is divided into bars, the elements of a flow.
struct MouthOfFlow {
  std::size_t bars_per_side = 2;
  double angle = 0;                        // of the current and the mouth about the vertical [rad]
  std::array<double, 3> middle{0, 0, -5};  // [m]
  double shear = 0;                        // growth of the current with the height above the middle [1/m]
  static constexpr double kHalfSide = 1;   // [m]

  /// Writes the place of a corner of the rim, and the current there, into the rows of a node.
  void put_node(std::size_t corner, std::size_t node, States& s) const {
    constexpr double kAcross[] = {-1, 1, 1, -1}, kUp[] = {-1, -1, 1, 1};
    const std::size_t side = corner / bars_per_side % 4, next = (side + 1) % 4;
    const double share = static_cast<double>(corner % bars_per_side) / static_cast<double>(bars_per_side),
                 across = kHalfSide * (kAcross[side] + share * (kAcross[next] - kAcross[side])),
                 up = kHalfSide * (kUp[side] + share * (kUp[next] - kUp[side])),
                 speed = kSpeedOfMouth * (1 + shear * up), c = std::cos(angle), sine = std::sin(angle);
    const double x[3] = {middle[0] - sine * across, middle[1] + c * across, middle[2] + up};
    const double current[3] = {c * speed, sine * speed, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      s.x[at(3 * node + axis, 0)] = x[axis];
      s.current[at(3 * node + axis, 0)] = current[axis];
    }
  }
  /// Residual of the flow's own terms in its equation, summed over the rim.
  double residual(const Bench& b, double unknown) const {
    double sum = 0;
    for (std::size_t bar = 0; bar < 4 * bars_per_side; ++bar) {
      States s = b.blank(0, 1);
      put_node(bar, 0, s);
      put_node(bar + 1, 1, s);
      s.x[at(b.dofs() - 3, 0)] = unknown;
      for (const auto& term : b.type.terms)
        sum += b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE).force[at(b.dofs() - 3, 0)];
    }
    return sum;
  }
};

/// Why the checks of a mouth do not apply to an element type; nullptr if they do.
const char* why_no_mouth(const Bench& b) {
  if (!b.type.is_flow()) return kIsNoFlow;
  if (b.type.element.stencil != NETLOFT_BAR) return "its elements are not the bars of a rim";
  return b.type.globals.size() == 1 ? nullptr : "it has several unknowns";
}

/// The unknown of a flow with a drag along x in its full reach, by Newton's method [m/s, N].
double unknown_with(const Bench& b, const MouthOfFlow& mouth, double drag) {
  constexpr double kStep = 1e-4;
  constexpr int kIterations = 20;
  WaterOfFlow water(b, 0.0);
  water.ask(b);
  double unknown = 0;
  for (int i = 0; i < kIterations; ++i) {
    const double slope =
        (mouth.residual(b, unknown + kStep) - mouth.residual(b, unknown - kStep)) / (2 * kStep);
    unknown -= (mouth.residual(b, unknown) - water.weight[0] * drag) / slope;
  }
  return unknown;
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

Finding still_water_stays_still(Bench& b) {
  return visit_water(b, kRoundingOfTurn, [&](WaterOfFlow water, Worst& worst) {
    std::fill(std::begin(water.current), std::end(water.current), 0.0);
    water.ask(b);
    for (std::size_t i = 0; i < 3 * kLanes; ++i)
      worst.note(std::abs(water.velocity[i]), [&] { return lane_place(i % kLanes); });
  });
}

/// Checks the balance of momentum of gear and water (W. Froude): with the mass flow ρ A w through the mouth,
/// the drag D takes 2 (V − w) from the velocity far behind, D = 2 ρ A w (V − w), for slight D.
Finding lost_momentum_is_the_drag(Bench& b) {
  if (const char* why = why_no_mouth(b)) return not_applicable(why);
  const double area = 4 * MouthOfFlow::kHalfSide * MouthOfFlow::kHalfSide,
               drag = kSlight * 0.5 * kDensity * kSpeedOfMouth * kSpeedOfMouth * area;
  WaterOfFlow water(b, unknown_with(b, {}, drag));
  water.ask(b);
  const double w = water.velocity[0];
  Worst worst(kSlightLimit);
  worst.note(std::abs(2 * kDensity * area * w * (kSpeedOfMouth - w) / drag - 1),
             [&] { return "with a drag of " + number_text(drag) + " N behind a mouth of 4 m2"; });
  return judged(worst, kIsNoFlow);
}

Finding mouth_is_the_same_in_any_frame(Bench& b) {
  if (const char* why = why_no_mouth(b)) return not_applicable(why);
  const double here = MouthOfFlow{}.residual(b, kInducedOfMouth),
               there = MouthOfFlow{.angle = kTurnOfCurrent, .middle = {7.3, -5.9, -9}}.residual(
                   b, kInducedOfMouth);
  Worst worst(kFrameLimit);
  worst.note(ratio(there - here, here), [] { return "a mouth that is turned with the current, and moved"; });
  return judged(worst, kIsNoFlow);
}

/// Checks that with bars of half the length, and of a quarter, the equation changes less and less.
Finding finer_rims_converge(Bench& b) {
  if (const char* why = why_no_mouth(b)) return not_applicable(why);
  const auto of = [&](std::size_t bars) {
    return MouthOfFlow{.bars_per_side = bars, .shear = 0.3}.residual(b, kInducedOfMouth);
  };
  const double coarse = of(4), fine = of(8), finest = of(16);
  // The error falls by at least half with a scheme of first order.
  Worst worst(0.6);
  worst.note(ratio(finest - fine, std::abs(fine - coarse) + kFrameLimit * std::abs(finest)),
             [] { return "rims of 32 and 64 bars against 16 and 32"; });
  return judged(worst, kIsNoFlow);
}

}  // namespace netloft::conformance
