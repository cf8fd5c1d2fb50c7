// SPDX-License-Identifier: BSD-3-Clause
// Checks that the forces of the members that an element declares add up to the forces of its terms with
// NETLOFT_OF_MEMBERS.
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

/// Sum of the forces and energies of the members of one element.
struct Pull {
  double energy = 0;
  std::vector<double> force;  // sum of the forces, by degree of freedom
};

/// Adds the energy E and the forces f_i on the nodes of a member (netloft_member: coefficients c, tension T,
/// rest length l₀) at a state of its element. Returns false if the member has no length and therefore no
/// direction.
///   l = ‖w‖, w = Σ c x,  E = ½ number T (l − l₀),  f_i = number c_i T w/l
bool add_member(const netloft_member& m, const States& s, std::size_t lane, Pull& sum) {
  double w[3] = {};
  const std::size_t nodes = std::min<std::size_t>(3, sum.force.size() / 3);
  for (std::size_t node = 0; node < nodes; ++node)
    for (std::size_t axis = 0; axis < 3; ++axis) w[axis] += m.c[node] * s.x[at(3 * node + axis, lane)];
  const double l = std::hypot(w[0], w[1], w[2]), strain = l / m.rest_length - 1;
  if (!(l > 0)) return false;
  const double T = (strain > 0 ? m.EA : m.EA_compression) * strain;
  sum.energy += 0.5 * m.number * T * (l - m.rest_length);
  for (std::size_t node = 0; node < nodes; ++node)
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum.force[3 * node + axis] += m.number * m.c[node] * T * w[axis] / l;
  return true;
}

/// Sum of the terms with NETLOFT_OF_MEMBERS, for all elements of a tile.
Answer answer_of_terms(const Bench& b, const States& s) {
  Answer sum;
  sum.energy.assign(kLanes, 0.0);
  sum.force.assign(b.dofs() * kLanes, 0.0);
  for (const auto& term : b.type.terms)
    if (term.traits & NETLOFT_OF_MEMBERS)
      b.specimen->evaluate(term, s, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE, {}, sum);
  return sum;
}

const netloft_term& term_of_members(const ElementType& type) {
  return *std::find_if(type.terms.begin(), type.terms.end(),
                       [](const netloft_term& t) { return (t.traits & NETLOFT_OF_MEMBERS) != 0; });
}

/// Largest difference between the members and the terms, in a force or in the energy divided by the size of
/// the element.
double difference(const Answer& term, const Pull& members, std::size_t lane, double size) {
  double off = std::abs(term.energy[lane] - members.energy) / size;
  for (std::size_t d = 0; d < members.force.size(); ++d)
    off = std::max(off, std::abs(term.force[at(d, lane)] - members.force[d]));
  return off;
}

void compare(Bench& b, const States& s, Worst& worst) {
  const netloft_term& term = term_of_members(b.type);
  const Answer sum = answer_of_terms(b, s);
  const auto declared = b.specimen->members(s.first, s.count);
  const auto scale = b.force_scale(term, s);
  const std::size_t count = b.type.members.count;
  for (std::size_t lane = 0; lane < s.count; ++lane) {
    Pull members{0, std::vector<double>(b.dofs(), 0.0)};
    bool has_direction = declared.size() == count * s.count;
    for (std::size_t i = 0; i < count && has_direction; ++i)
      has_direction = add_member(declared[lane * count + i], s, lane, members);
    const double off = has_direction ? difference(sum, members, lane, b.size(s, lane)) : std::nan("");
    worst.note(ratio(off, scale[lane]), [&] { return b.place(term, s, lane); });
  }
}

}  // namespace

/// Checks that the members add up to their terms. Rounding is far below the limit: in an element of 1 mm at a
/// coordinate of 10 m, rounding causes a strain of 1e-12.
Finding members_make_their_term(Bench& b) {
  if (b.type.members.count == 0) return not_applicable("the element declares no members");
  Worst worst(1e-6);
  for (const auto& s : b.tiles) compare(b, s, worst);
  return judged(worst, "no state");
}

}  // namespace netloft::conformance
