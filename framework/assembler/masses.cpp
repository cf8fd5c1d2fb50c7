// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/masses.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace netloft {

namespace {

/// Entry (r, c) of the tangents of all 64 elements of a tile. The tangent is stored as a packed triangle if
/// `symmetric`, otherwise as a full square.
const double* entry_of(const double* tangent, bool symmetric, std::size_t dofs, std::size_t r,
                       std::size_t c) {
  const std::size_t at = symmetric ? packed(std::max(r, c)) + std::min(r, c) : r * dofs + c;
  return tangent + at * kTileLanes;
}

double largest_lane(std::span<const double> lanes) {
  double largest = 0;
  for (const double m : lanes) largest = std::max(largest, std::abs(m));
  return largest;
}

/// The unknown in row `row`, divided by the coordinate that the element sees: the arm of the body (metres per
/// radian) for rotations, otherwise 1.
double turn_factor(const ElementFamily& f, std::size_t element, std::size_t row) {
  return row / 3 == 1 ? f.arm(element) : 1;
}

/// The index of the body to which an element belongs. The rotation nodes of bodies have consecutive numbers.
std::size_t body_of(const ElementFamily& f, std::size_t element,
                    std::span<const std::array<std::uint32_t, 2>> bodies) {
  const std::size_t body = f.node(element, 1) - bodies.front()[1];
  assert(bodies[body][0] == f.node(element, 0));
  return body;
}

/// Adds entry (r, c) of elements that belong to bodies. In the rows of an element, the origin of the body is
/// first, then its rotation, and then shared unknowns.
void add_on_bodies(const ElementFamily& f, const netloft_tile& t, std::size_t r, std::size_t c,
                   const double* lanes, std::span<const std::array<std::uint32_t, 2>> bodies,
                   MassBlocks& masses) {
  for (std::size_t lane = 0; lane < t.count; ++lane) {
    const std::size_t e = t.first + lane;
    const double m = lanes[lane] / (turn_factor(f, e, r) * turn_factor(f, e, c));
    if (r / 3 == c / 3)
      masses.nodes[9 * std::size_t{f.node(e, static_cast<int>(r / 3))} + 3 * (r % 3) + c % 3] += m;
    else if (r < 3 && c / 3 == 1)
      masses.between[9 * body_of(f, e, bodies) + 3 * r + c % 3] += m;
    else if (r / 3 != 1 || c >= 3)
      masses.coupled = std::max(masses.coupled, std::abs(m));
  }
}

void add_on_nodes(const ElementFamily& f, const netloft_tile& t, std::size_t r, std::size_t c,
                  const double* lanes, MassBlocks& masses) {
  if (r / 3 != c / 3) {
    masses.coupled = std::max(masses.coupled, largest_lane({lanes, t.count}));
    return;
  }
  for (std::size_t lane = 0; lane < t.count; ++lane)
    masses.nodes[9 * std::size_t{f.node(t.first + lane, static_cast<int>(r / 3))} + 3 * (r % 3) + c % 3] +=
        lanes[lane];
}

bool add_term(TileEvaluator& elements, std::size_t family, const netloft_term& term,
              std::span<const std::array<std::uint32_t, 2>> bodies, std::span<const double> x,
              MassBlocks& masses) {
  const ElementFamily& f = *elements.tiles().families[family];
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  const bool symmetric = term.traits & NETLOFT_SYMMETRIC;
  const auto evaluate = [&](std::size_t, netloft_tile& t, TileSums& sums) {
    t.force = nullptr;
    t.tangent = sums.scratch.data();
    std::fill_n(t.tangent, (symmetric ? packed(dofs) : dofs * dofs) * kTileLanes, 0.0);
    t.want = NETLOFT_WANT_TANGENT;
    return f.evaluate(term, t);
  };
  const auto add = [&](std::size_t, const netloft_tile& t, const TileSums& sums) {
    for (std::size_t r = 0; r < dofs; ++r)
      for (std::size_t c = 0; c < dofs; ++c) {
        const double* lanes = entry_of(sums.scratch.data(), symmetric, dofs, r, c);
        if (f.type().is_on_body())
          add_on_bodies(f, t, r, c, lanes, bodies, masses);
        else
          add_on_nodes(f, t, r, c, lanes, masses);
      }
  };
  return elements.visit(x, {.cu = 0, .cv = 0, .ca = 1}, family, evaluate, add);
}

}  // namespace

bool add_masses(TileEvaluator& elements, std::span<const std::array<std::uint32_t, 2>> bodies,
                std::span<const double> x, MassBlocks& masses) {
  const auto families = elements.tiles().families;
  for (std::size_t f = 0; f < families.size(); ++f)
    for (const auto& term : families[f]->active_terms())
      if ((term.traits & NETLOFT_READS_ACCELERATION) && !add_term(elements, f, term, bodies, x, masses))
        return false;
  return true;
}

void turn_mass(const std::array<double, 9>& Q, double* M) {
  double left[9] = {}, both[9] = {};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) left[3 * i + j] += Q[3 * k + i] * M[3 * k + j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) both[3 * i + j] += left[3 * i + k] * Q[3 * k + j];
  std::copy_n(both, 9, M);
}

}  // namespace netloft
