// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/bench.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

/// Largest allowed difference of two answers that must be equal up to rounding.
inline constexpr double kMotionLimit = 1e-8;

inline bool is_from_outside(const netloft_term& term) { return term.traits & NETLOFT_FROM_OUTSIDE; }

/// The request for all results that a term can give, except its matrix.
inline std::uint32_t all_of(const netloft_term& term) {
  return NETLOFT_WANT_FORCE | (term.traits & NETLOFT_CONSERVATIVE ? std::uint32_t{NETLOFT_WANT_ENERGY} : 0u);
}

/// Largest difference of two answers for element `lane`. Forces are relative to `scale`, the force of the
/// element; energies are relative to `scale` times the size of the element.
inline double difference(const Bench& b, const Answer& one, const Answer& two, const States& s, double scale,
                         std::size_t lane) {
  double worst = 0;
  for (std::size_t d = 0; d < b.dofs(); ++d)
    worst = std::max(worst, ratio(one.force[at(d, lane)] - two.force[at(d, lane)], scale));
  if (one.energy.empty()) return worst;
  const double energy = scale * b.size(s, lane) + std::abs(one.energy[lane]);
  return std::max(worst, ratio(one.energy[lane] - two.energy[lane], energy));
}

/// Compares the answer at `there`, the transformed states, with `expected`, the transformed answer at the
/// states `s`.
inline void compare(Bench& b, const netloft_term& term, const States& s, const Answer& expected,
                    const States& there, Worst& worst) {
  const Answer found = b.specimen->evaluate(term, there, all_of(term));
  const auto scale = b.force_scale(term, s);
  for (std::size_t lane = 0; lane < s.count; ++lane)
    worst.note(found.ok() ? difference(b, expected, found, s, scale[lane], lane) : std::nan(""),
               [&] { return b.place(term, s, lane) + (found.ok() ? "" : ": " + found.message); });
}

}  // namespace netloft::conformance
