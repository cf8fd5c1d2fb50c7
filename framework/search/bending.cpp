// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/bending.hpp"

#include "framework/judging/linear_motion.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// A conservative term with one of these traits is not bending.
constexpr std::uint32_t kNotBending = NETLOFT_CONSTANT | NETLOFT_FROM_OUTSIDE | NETLOFT_OF_MEMBERS;

/// Whether the tangent at x minus the tangent `bending` is positive definite, except for rounding errors. If
/// the forces are not defined at x, the result is true.
bool is_convex_without(Assembler& assembler, std::span<const double> x, std::span<const double> bending,
                       Factors& factors) {
  std::vector<double> rest(assembler.value_slots()), metric(rest.size());
  factors.statistics().matrices += 2;
  if (!assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = rest.data()}) ||
      !assembler.evaluate(assembler.start(), {.matrix = MatrixKind::metric, .values = metric.data()}))
    return true;
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] += kRoundingOfMatrix * metric[i] - bending[i];
  rest.resize(assembler.pattern().value_slots());
  return factors.factorise(assembler.pattern(), false, rest) == NETLOFT_FACTOR_OK;
}

}  // namespace

bool resists_bending(const Assembler& assembler) {
  for (const auto& family : assembler.families())
    for (const auto& term : family->active_terms())
      if ((term.traits & NETLOFT_CONSERVATIVE) && !(term.traits & kNotBending)) return true;
  return false;
}

double bending_that_holds(Assembler& assembler, std::span<const double> u, Factors& factors) {
  std::vector<double> x = assembler.start(), forces(x.size()), bending(assembler.value_slots());
  assembler.place(u, x);
  ++factors.statistics().matrices;
  if (!assembler.evaluate(x, {.conservative_only = true,
                              .without = kNotBending,
                              .residual = forces.data(),
                              .matrix = MatrixKind::exact,
                              .values = bending.data()}))
    return 0;
  if (is_convex_without(assembler, x, bending, factors)) return 0;
  double largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(forces[i]));
  return largest;
}

}  // namespace netloft
