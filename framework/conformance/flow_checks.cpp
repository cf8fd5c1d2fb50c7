// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

constexpr double kFlowLimit = 1e-10;
constexpr const char* kNoCurrent = "no term reads the current";

bool feels_water(const netloft_term& term) {
  return (term.traits & NETLOFT_READS_CURRENT) && !(term.traits & NETLOFT_FROM_OUTSIDE);
}

/// Returns states in which all nodes of an element have one velocity, the water at all its nodes has one
/// velocity, and nothing accelerates. A passive element can only take energy out of this flow.
States in_uniform_flow(const Bench& b, const netloft_term& term, States s) {
  for (std::size_t d = 0; d < b.dofs(); ++d)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      s.current[at(d, lane)] = s.current[at(d % 3, lane)];
      s.v[at(d, lane)] = term.traits & NETLOFT_READS_VELOCITY ? s.v[at(d % 3, lane)] : 0;
      s.a[at(d, lane)] = s.current_dz[at(d, lane)] = 0;
      if (b.type.is_on_body() && d / 3 == 1)
        s.v[at(d, lane)] = s.current[at(d, lane)] = 0;  // bodies do not rotate
    }
  return s;
}

double largest_force(const Bench& b, const Answer& a, std::size_t lane) {
  double most = 0;
  for (std::size_t d = 0; d < b.dofs(); ++d) most = std::max(most, std::abs(a.force[at(d, lane)]));
  return most;
}

}  // namespace

Finding no_force_without_flow(Bench& b) {
  Worst worst(kFlowLimit);
  for (const auto& term : b.type.terms) {
    if (!feels_water(term)) continue;
    for (const auto& tile : b.tiles) {
      const States flowing = in_uniform_flow(b, term, tile);
      States drifting = flowing;
      drifting.current = flowing.v;
      const Answer full = b.specimen->evaluate(term, flowing, NETLOFT_WANT_FORCE);
      const Answer none = b.specimen->evaluate(term, drifting, NETLOFT_WANT_FORCE);
      for (std::size_t lane = 0; lane < tile.count; ++lane)
        worst.note(ratio(largest_force(b, none, lane), largest_force(b, full, lane)),
                   [&] { return b.place(term, tile, lane) + ", drifting with the water"; });
    }
  }
  return judged(worst, kNoCurrent);
}

/// Checks that the power of the physical force −r relative to the water, −r·(v − c), is not positive.
Finding never_gains_energy(Bench& b) {
  Worst worst(kFlowLimit);
  for (const auto& term : b.type.terms) {
    if (!feels_water(term)) continue;
    for (const auto& tile : b.tiles) {
      const States s = in_uniform_flow(b, term, tile);
      const Answer a = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE);
      for (std::size_t lane = 0; lane < s.count; ++lane) {
        double power = 0, size = 0;
        for (std::size_t d = 0; d < b.dofs(); ++d) {
          const double slip = s.v[at(d, lane)] - s.current[at(d, lane)];
          power -= a.force[at(d, lane)] * slip;
          size += std::abs(a.force[at(d, lane)] * slip);
        }
        worst.note(ratio(std::max(power, 0.0), size), [&] { return b.place(term, tile, lane); });
      }
    }
  }
  return judged(worst, kNoCurrent);
}

/// Checks that each element tells its laws its length of twine or its area of netting. These lengths and
/// areas are the weights with which reports state how much of a gear is outside the range of a law.
Finding says_how_much_it_stands_for(Bench& b) {
  if (b.type.laws.empty()) return not_applicable("it has no slot for a law");
  for (const auto& term : b.type.terms)
    if (term.traits & NETLOFT_READS_CURRENT)
      for (const auto& tile : b.tiles) b.specimen->evaluate(term, tile, NETLOFT_WANT_FORCE);
  const LaneCounts& law_lanes = b.specimen->law_lanes();
  if (law_lanes.all == 0) return not_applicable("it passes no extents to its laws");
  if (law_lanes.wrong > 0)
    return failed(std::to_string(law_lanes.wrong) + " of " + std::to_string(law_lanes.all) +
                  " lanes have no positive length of twine or area of netting");
  return {};
}

}  // namespace netloft::conformance
