// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/carried_answers.hpp"
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

constexpr double kLowDigits = 1e-3;  // shift relative to the distance of nodes; far above rounding
constexpr const char* kAllFromOutside = "all terms act from outside the element";

/// Whether all forces of a term act between nodes of its element: none is due to weight, water or inertia.
bool is_internal(const Bench& b, const netloft_term& term) {
  return !b.type.is_on_body() &&
         !(term.traits & (NETLOFT_FROM_OUTSIDE | NETLOFT_NEEDS_GRAVITY | NETLOFT_NEEDS_FLOW |
                          NETLOFT_READS_CURRENT | NETLOFT_READS_ACCELERATION | NETLOFT_NEEDS_WAVES));
}

/// Difference between `found` and the nearer of two answers; infinite if an evaluation failed.
double least_difference(const Bench& b, const Answer& found, const Answer& one, const Answer& other,
                        const States& s, double scale, std::size_t lane) {
  double least = std::numeric_limits<double>::infinity();
  for (const Answer* expected : {&one, &other})
    if (expected->ok() && found.ok())
      least = std::min(least, difference(b, *expected, found, s, scale, lane));
  return least;
}

/// Moves the elements together with the bed below them.
States translated(const Bench& b, States s, const double (&by)[3]) {
  for (std::size_t d = 0; d < b.dofs(); ++d)
    for (std::size_t lane = 0; lane < s.count && !b.is_turn(d); ++lane) s.x[at(d, lane)] += by[d % 3];
  lift_bed(s, by[2]);
  return s;
}

/// Rotates every vector of a field [dof][64] about z.
void turn(std::vector<double>& field, double angle) {
  const double c = std::cos(angle), sine = std::sin(angle);
  for (std::size_t i = 0; i + 2 * kLanes < field.size(); ++i) {
    if (i / kLanes % 3 != 0) continue;
    const double x = field[i], y = field[i + kLanes];
    field[i] = c * x - sine * y;
    field[i + kLanes] = sine * x + c * y;
  }
}

States turned(States s, double angle) {
  for (auto field :
       {&States::x, &States::v, &States::a, &States::current, &States::current_dz, &States::swing})
    turn(s.*field, angle);
  turn_ground(s, angle);
  return s;
}

}  // namespace

Finding low_digits_ignored_or_taken(Bench& b) {
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms)
    for (const auto& s : b.tiles) {
      States low = s;
      low.x_low = b.random_field();
      for (std::size_t d = 0; d < b.dofs(); ++d)
        for (std::size_t lane = 0; lane < s.count; ++lane)
          low.x_low[at(d, lane)] *= kLowDigits * b.spacing(s, lane);
      States moved_there = s;
      for (std::size_t i = 0; i < s.x.size(); ++i) moved_there.x[i] += low.x_low[i];
      const Answer ignored = b.specimen->evaluate(term, s, all_of(term)),
                   taken = b.specimen->evaluate(term, moved_there, all_of(term)),
                   found = b.specimen->evaluate(term, low, all_of(term));
      const auto scale = b.force_scale(term, s);
      for (std::size_t lane = 0; lane < s.count; ++lane)
        worst.note(least_difference(b, found, ignored, taken, s, scale[lane], lane),
                   [&] { return b.place(term, s, lane); });
    }
  return judged(worst, "there are no terms");
}

Finding translation_changes_nothing(Bench& b) {
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms) {
    if (is_from_outside(term)) continue;
    const double vertical = term.traits & NETLOFT_NEEDS_GRAVITY ? 0 : 3.7;
    for (const auto& s : b.tiles) {
      const Answer here = b.specimen->evaluate(term, s, all_of(term));
      compare(b, term, s, here, translated(b, s, {7.3, -5.9, vertical}), worst);
    }
  }
  return judged(worst, kAllFromOutside);
}

Finding rotation_turns_the_force(Bench& b) {
  Worst worst(kMotionLimit);
  if (b.type.is_on_body()) return not_applicable("bodies have a check of their own");
  for (const auto& term : b.type.terms) {
    if (is_from_outside(term)) continue;
    for (const auto& s : b.tiles) {
      const double angle = b.sampler.uniform(0.3, 1.2);
      Answer expected = b.specimen->evaluate(term, s, all_of(term));
      turn(expected.force, angle);
      compare(b, term, s, expected, turned(s, angle), worst);
    }
  }
  return judged(worst, kAllFromOutside);
}

Finding forces_sum_to_zero(Bench& b) {
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms) {
    if (!is_internal(b, term)) continue;
    for (const auto& s : b.tiles) {
      const Answer a = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE);
      const auto scale = b.force_scale(term, s);
      for (std::size_t lane = 0; lane < s.count; ++lane) {
        double sum[3] = {};
        for (std::size_t d = 0; d < b.dofs(); ++d) sum[d % 3] += a.force[at(d, lane)];
        for (const double component : sum)
          worst.note(ratio(component, scale[lane]), [&] { return b.place(term, s, lane); });
      }
    }
  }
  return judged(worst, "no term acts between nodes alone");
}

Finding moments_sum_to_zero(Bench& b) {
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms) {
    if (!is_internal(b, term)) continue;
    for (const auto& s : b.tiles) {
      const Answer a = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE);
      const auto scale = b.force_scale(term, s);
      for (std::size_t lane = 0; lane < s.count; ++lane)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
          double moment = 0;
          for (std::size_t node = 3; node < b.dofs(); node += 3) {
            const double rp = s.x[at(node + p, lane)] - s.x[at(p, lane)];
            const double rq = s.x[at(node + q, lane)] - s.x[at(q, lane)];
            moment += rp * a.force[at(node + q, lane)] - rq * a.force[at(node + p, lane)];
          }
          worst.note(ratio(moment, scale[lane] * b.spacing(s, lane)), [&] { return b.place(term, s, lane); });
        }
    }
  }
  return judged(worst, "no term acts between nodes alone");
}

}  // namespace netloft::conformance
