// SPDX-License-Identifier: BSD-3-Clause
// Checks of the physics of a law: without flow there is no force, the force never adds energy, and the force
// does not depend on the orientation of the axes.
#include "framework/conformance/law_checks.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

constexpr double kFlowRounding = 1e-10;

/// Reverses the sign of one array of the flows, and compares the force with `sign` times the original force.
Finding compare_turned_over(LawBench& b, std::vector<double> Flows::*array, double sign) {
  Worst worst(kFlowRounding);
  for (std::size_t part = 0; part < b.tiles.size(); ++part) {
    Flows over = b.tiles[part];
    for (double& v : over.*array) v = -v;
    const auto scale = b.force_scale(part, over);
    const LawAnswer here = b.evaluate(part, b.tiles[part], false), there = b.evaluate(part, over, false);
    for (std::size_t i = 0; i < here.force.size(); ++i)
      worst.note(ratio(there.force[i] - sign * here.force[i], scale[i % kLanes]),
                 [&] { return b.place(part, i % kLanes); });
  }
  return judged(worst, "");
}

/// Rotates every vector of an array [3][64] about z.
void turn_flow(std::vector<double>& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double x = v[at(0, lane)], y = v[at(1, lane)];
    v[at(0, lane)] = c * x - s * y;
    v[at(1, lane)] = s * x + c * y;
  }
}

}  // namespace

Finding law_needs_flow(LawBench& b) {
  Worst worst(kFlowRounding);
  for (std::size_t part = 0; part < b.tiles.size(); ++part) {
    Flows still = b.tiles[part];
    std::fill(still.flow.begin(), still.flow.end(), 0.0);
    const auto scale = b.force_scale(part, b.tiles[part]);
    const LawAnswer a = b.evaluate(part, still, false);
    for (std::size_t i = 0; i < a.force.size(); ++i)
      worst.note(ratio(a.force[i], scale[i % kLanes]), [&] { return b.place(part, i % kLanes); });
  }
  return judged(worst, "");
}

/// The power of the force relative to the water, F·W, must not be negative.
Finding law_never_gains_energy(LawBench& b) {
  Worst worst(kFlowRounding);
  for (std::size_t part = 0; part < b.tiles.size(); ++part) {
    const Flows& f = b.tiles[part];
    const LawAnswer a = b.evaluate(part, f, false);
    const auto scale = b.force_scale(part, f);
    for (std::size_t lane = 0; lane < f.count; ++lane) {
      double power = 0;
      for (std::size_t i = 0; i < 3; ++i) power += a.force[at(i, lane)] * f.flow[at(i, lane)];
      worst.note(ratio(std::max(-power, 0.0), scale[lane] * b.reach(f, lane)),
                 [&] { return b.place(part, lane); });
    }
  }
  return judged(worst, "");
}

Finding rotation_turns_the_force_of_a_law(LawBench& b) {
  Worst worst(kFlowRounding);
  for (std::size_t part = 0; part < b.tiles.size(); ++part) {
    Flows turned = b.tiles[part];
    const double angle = b.sampler.uniform(0.3, 1.2);
    turn_flow(turned.flow, angle);
    turn_flow(turned.direction, angle);
    LawAnswer expected = b.evaluate(part, b.tiles[part], false);
    turn_flow(expected.force, angle);
    const LawAnswer found = b.evaluate(part, turned, false);
    const auto scale = b.force_scale(part, turned);
    for (std::size_t i = 0; i < found.force.size(); ++i)
      worst.note(ratio(found.force[i] - expected.force[i], scale[i % kLanes]),
                 [&] { return b.place(part, i % kLanes); });
  }
  return judged(worst, "");
}

Finding law_is_odd_in_flow(LawBench& b) { return compare_turned_over(b, &Flows::flow, -1); }
Finding law_is_even_in_direction(LawBench& b) { return compare_turned_over(b, &Flows::direction, 1); }

}  // namespace netloft::conformance
