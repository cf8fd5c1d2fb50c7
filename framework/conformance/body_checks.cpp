// SPDX-License-Identifier: BSD-3-Clause
// Checks of elements on rigid bodies: several rotation vectors describe the same rotation, and results must
// not depend on the choice among them.
#include "framework/conformance/carried_answers.hpp"
#include "framework/conformance/checks.hpp"

#include <netloft/rotation.hpp>

namespace netloft::conformance {

namespace {

constexpr const char* kNoBody = "the element is not on a body";
constexpr double kTurn = 6.283185307179586;

using V = Vec3<double>;

/// Reads three rows of a field [dof][64], which are the origin or the rotation of a body.
V read(const std::vector<double>& field, std::size_t first, std::size_t lane) {
  return {field[at(first, lane)], field[at(first + 1, lane)], field[at(first + 2, lane)]};
}
void write(std::vector<double>& field, std::size_t first, std::size_t lane, const V& value) {
  for (std::size_t k = 0; k < 3; ++k) field[at(first + k, lane)] = value[static_cast<int>(k)];
}

/// Whether a rotation vector is close to a full turn, where its rate does not determine the angular velocity.
bool is_near_a_turn(const V& psi) {
  const double turns = norm(psi) / kTurn;
  return turns > 0.5 && std::abs(turns - std::round(turns)) < 0.1;
}

/// Position and motion of one body, independent of its rotation vector.
struct Moving {
  V x, v, a, omega, alpha, current, current_dz;
};
Moving read_body(const States& s, std::size_t lane) {
  const V psi = read(s.x, 3, lane), rate = read(s.v, 3, lane);
  return {read(s.x, 0, lane),
          read(s.v, 0, lane),
          read(s.a, 0, lane),
          spin_of(psi, rate),
          spin_rate_of(psi, rate, read(s.a, 3, lane)),
          read(s.current, 0, lane),
          read(s.current_dz, 0, lane)};
}
void write_body(const Moving& m, const V& psi, States& s, std::size_t lane) {
  const V rate = rate_of_spin(psi, m.omega);
  write(s.x, 0, lane, m.x);
  write(s.x, 3, lane, psi);
  write(s.v, 0, lane, m.v);
  write(s.v, 3, lane, rate);
  write(s.a, 0, lane, m.a);
  write(s.a, 3, lane, rate_of_spin(psi, m.alpha - spin_rate_of(psi, rate, V{})));
  write(s.current, 0, lane, m.current);
  write(s.current_dz, 0, lane, m.current_dz);
}

/// The moment that does the same work as a generalised force on a rotation vector.
V moment_of(const V& psi, const V& generalised) { return rate_of_spin(-psi, generalised); }

/// Transforms the states of a tile's elements and the answers of a term. `carry(motion, psi)` changes the
/// motion and returns the new rotation vector; `turn(vector, is_axial)` transforms a force or moment.
template <class Carry, class Turn>
void carry_lanes(const States& from, const Answer& answer, const Carry& carry, const Turn& turn, States& to,
                 Answer& expected) {
  to = from;
  expected = answer;
  for (std::size_t lane = 0; lane < from.count; ++lane) {
    const V psi = read(from.x, 3, lane);
    Moving m = read_body(from, lane);
    const V there = carry(m, psi);
    write_body(m, there, to, lane);
    const V moment = moment_of(psi, read(answer.force, 3, lane));
    write(expected.force, 0, lane, turn(read(answer.force, 0, lane), false));
    write(expected.force, 3, lane, moment_on_vector(there, turn(moment, true)));
  }
}

/// Draws rotations again if they are close to a full turn.
States away_from_turns(Bench& b, States s) {
  for (std::size_t lane = 0; lane < s.count; ++lane)
    for (V psi = read(s.x, 3, lane); is_near_a_turn(psi); psi = read(s.x, 3, lane)) {
      double axis[3];
      b.sampler.direction(axis);
      write(s.x, 3, lane, b.sampler.uniform(0, 2 * kTurn) * V{axis[0], axis[1], axis[2]});
    }
  return s;
}

/// Compares a term before and after a rotation of the world by the vector `by`. If the vertical matters to
/// the term (gravity, a bed, a current that varies with depth), `by` must be along z.
void note_in_turned_world(Bench& b, const netloft_term& term, States s, const V& by, Worst& worst) {
  const auto turn = [&](const V& w, bool) { return rotated(by, w); };
  const auto carry = [&](Moving& m, const V& psi) {
    for (V* w : {&m.x, &m.v, &m.a, &m.omega, &m.alpha, &m.current, &m.current_dz}) *w = rotated(by, *w);
    auto axes = turned_axes(psi);
    for (V& axis : axes) axis = rotated(by, axis);
    return rotation_vector(axes);
  };
  States there;
  Answer expected;
  carry_lanes(s, b.specimen->evaluate(term, s, all_of(term)), carry, turn, there, expected);
  turn_ground(there, by.z);
  compare(b, term, s, expected, there, worst);
}

}  // namespace

Finding body_turns_with_the_world(Bench& b) {
  if (!b.type.is_on_body()) return not_applicable(kNoBody);
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms)
    for (const auto& tile : b.tiles) {
      if (is_from_outside(term)) continue;
      States s = away_from_turns(b, tile);
      note_in_turned_world(b, term, s, {0, 0, b.sampler.uniform(-3, 3)}, worst);
      if (term.traits & NETLOFT_NEEDS_GRAVITY) continue;
      std::fill(s.current_dz.begin(), s.current_dz.end(), 0.0);
      s.bed.clear();
      s.ground.clear();
      double axis[3];
      b.sampler.direction(axis);
      note_in_turned_world(b, term, s, b.sampler.uniform(0.5, 3) * V{axis[0], axis[1], axis[2]}, worst);
    }
  return judged(worst, "all terms act from outside the element");
}

/// Checks that one or two additional full turns change nothing.
Finding full_turns_change_nothing(Bench& b) {
  if (!b.type.is_on_body()) return not_applicable(kNoBody);
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms)
    for (const auto& tile : b.tiles)
      for (const double turns : {1.0, 2.0, -2.0}) {
        const States s = away_from_turns(b, tile);
        const auto carry = [&](Moving&, const V& psi) {
          return norm(psi) > 0 ? (1 + turns * kTurn / norm(psi)) * psi : psi;
        };
        States there;
        Answer expected;
        carry_lanes(
            s, b.specimen->evaluate(term, s, all_of(term)), carry, [](const V& w, bool) { return w; }, there,
            expected);
        compare(b, term, s, expected, there, worst);
      }
  return judged(worst, "there are no terms");
}

/// Compares an element with its mirror image in the plane y = 0, which is on a body on the other side of the
/// gear. A reflection reverses the components x and z of axial vectors, and the component y of all other
/// vectors.
Finding sides_mirror_each_other(Bench& b) {
  const auto is_side = [](const netloft_datum& d) { return std::string_view(d.name) == datum::kSide.name; };
  const auto at = std::ranges::find_if(b.type.data, is_side);
  if (!b.type.is_on_body() || at == b.type.data.end()) return not_applicable("the element has no side");
  Sample other = b.sample;
  for (double& side : other.data[static_cast<std::size_t>(at - b.type.data.begin())]) side = -side;
  const Specimen mirrored(b.type, other);
  const auto reflect = [](const V& w, bool is_axial) {
    return is_axial ? V{-w.x, w.y, -w.z} : V{w.x, -w.y, w.z};
  };
  const auto carry = [&](Moving& m, const V& psi) {
    for (V* w : {&m.x, &m.v, &m.a, &m.current, &m.current_dz}) *w = reflect(*w, false);
    for (V* w : {&m.omega, &m.alpha}) *w = reflect(*w, true);
    return reflect(psi, true);
  };
  Worst worst(kMotionLimit);
  for (const auto& term : b.type.terms)
    for (const auto& tile : b.tiles) {
      if (is_from_outside(term)) continue;
      const States s = away_from_turns(b, tile);
      States there;
      Answer expected;
      carry_lanes(s, b.specimen->evaluate(term, s, all_of(term)), carry, reflect, there, expected);
      reflect_ground(there);
      const Answer found = mirrored.evaluate(term, there, all_of(term));
      const auto scale = b.force_scale(term, s);
      for (std::size_t lane = 0; lane < s.count; ++lane)
        worst.note(difference(b, expected, found, s, scale[lane], lane),
                   [&] { return b.place(term, s, lane); });
    }
  return judged(worst, "all terms act from outside the element");
}

namespace {

/// Kinetic energy ½ q̇·M q̇ of every element, where M is the derivative of the force with respect to
/// acceleration.
std::vector<double> kinetic_energy(const Bench& b, const netloft_term& term, const States& s) {
  States as_rates = s;
  as_rates.a = s.v;
  std::fill(as_rates.v.begin(), as_rates.v.end(), 0.0);
  const Answer momentum = b.specimen->evaluate(term, as_rates, NETLOFT_WANT_FORCE);
  std::vector<double> energy(kLanes, 0.0);
  for (std::size_t i = 0; i < momentum.force.size(); ++i)
    energy[i % kLanes] += 0.5 * momentum.force[i] * s.v[i];
  return energy;
}

States later(States s, double t) {
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    s.x[i] += t * (s.v[i] + 0.5 * t * s.a[i]);
    s.v[i] += t * s.a[i];
  }
  return s;
}

}  // namespace

/// Checks, in water at rest, that the power of the inertia force is the rate of change of the kinetic energy,
/// also in rotation: r·q̇ = d/dt (½ q̇·M q̇).
Finding inertia_makes_kinetic_energy(Bench& b) {
  constexpr double kLimit = 1e-6, kStep = 1e-4;
  if (!b.type.is_on_body()) return not_applicable(kNoBody);
  Worst worst(kLimit);
  for (const auto& term : b.type.terms)
    for (States s : b.tiles) {
      if (!(term.traits & NETLOFT_READS_ACCELERATION)) continue;
      std::fill(s.current.begin(), s.current.end(), 0.0);
      std::fill(s.current_dz.begin(), s.current_dz.end(), 0.0);
      const Answer here = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE);
      const auto ahead = kinetic_energy(b, term, later(s, kStep)),
                 behind = kinetic_energy(b, term, later(s, -kStep));
      for (std::size_t lane = 0; lane < s.count; ++lane) {
        double power = 0, size = 0;
        for (std::size_t d = 0; d < b.dofs(); ++d) {
          power += here.force[at(d, lane)] * s.v[at(d, lane)];
          size += std::abs(here.force[at(d, lane)] * s.v[at(d, lane)]);
        }
        worst.note(ratio(power - (ahead[lane] - behind[lane]) / (2 * kStep), size),
                   [&] { return b.place(term, s, lane); });
      }
    }
  return judged(worst, "no term reads accelerations");
}

}  // namespace netloft::conformance
