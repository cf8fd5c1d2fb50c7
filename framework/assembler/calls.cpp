// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/assembler.hpp"
#include "framework/assembler/projection.hpp"
#include "framework/assembler/workspace.hpp"

#include <algorithm>

namespace netloft {

namespace {

std::uint32_t want_of(MatrixKind kind) {
  switch (kind) {
    case MatrixKind::exact:
      return NETLOFT_WANT_TANGENT;
    case MatrixKind::convex:
      return NETLOFT_WANT_CONVEX;
    case MatrixKind::metric:
      return NETLOFT_WANT_METRIC;
    default:
      return 0;
  }
}

/// Adds half the sum of a square tangent and its transpose to a packed one.
void add_symmetric_part(const double* __restrict square, std::size_t n, double* __restrict packed_tangent) {
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c <= r; ++c) {
      const double *here = square + (r * n + c) * kLanes, *there = square + (c * n + r) * kLanes;
      double* to = packed_tangent + (packed(r) + c) * kLanes;
      for (std::size_t lane = 0; lane < kLanes; ++lane) to[lane] += 0.5 * (here[lane] + there[lane]);
    }
}

}  // namespace

/// Calls the terms with an energy, or those without: sums begin with the former, so that the gradient of the
/// energy is the same to the bit whether or not the others follow. Mean forces of a step correct terms with
/// an energy. False: one could not be evaluated.
bool Assembler::call_families(const FamilyGroup& group, std::size_t tile, bool with_energy,
                              const Request& request, Workspace& w) {
  for (const std::size_t family : group.families) {
    w.message[0] = 0;
    netloft_tile t = make_tile(family, tile, request.motion, w);
    int status = call_terms(*families_[family], with_energy, t, request, w);
    if (status == NETLOFT_OK && request.between && with_energy)
      status = add_mean_forces(family, tile, t, request, w);
    if (status != NETLOFT_OK) return report(family, t, status, w), false;
  }
  return true;
}

int Assembler::call_terms(const ElementFamily& f, bool with_energy, netloft_tile& t, const Request& request,
                          Workspace& w) {
  if (const int status = call_each(f, f.active_terms(), with_energy, t, request, w); status != NETLOFT_OK)
    return status;
  const bool by_rates = request.values && request.matrix == MatrixKind::exact &&
                        (request.motion.cv != 0 || request.motion.ca != 0);
  return by_rates ? call_each(f, f.terms_of_motion(), with_energy, t, request, w) : NETLOFT_OK;
}

int Assembler::call_each(const ElementFamily& f, const std::vector<netloft_term>& terms, bool with_energy,
                         netloft_tile& t, const Request& request, Workspace& w) {
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  for (const auto& term : terms) {
    const bool conservative = term.traits & NETLOFT_CONSERVATIVE;
    if (conservative != with_energy || (term.traits & request.without)) continue;
    // Inertia is never left out, because without it the matrix of a time step would be singular.
    const bool counts =
        conservative || tangent_ != TangentChoice::elastic || (term.traits & NETLOFT_READS_ACCELERATION);
    const bool moving = !(term.traits & NETLOFT_CONSTANT) && counts;
    const bool symmetric = term.traits & NETLOFT_SYMMETRIC;
    const bool matrix_here = request.values && moving && request.matrix == MatrixKind::exact &&
                             (symmetric || (tangent_ == TangentChoice::exact && !pattern_.symmetric));
    t.energy = request.energy && conservative ? w.energy : nullptr;
    t.force = request.residual ? w.force.open(dofs, t.count) : nullptr;
    t.tangent = matrix_here ? w.open_tangent(symmetric, dofs, t.count) : nullptr;
    t.want = 0;
    if (t.energy) t.want |= NETLOFT_WANT_ENERGY;
    if (t.force) t.want |= NETLOFT_WANT_FORCE;
    if (t.tangent) t.want |= NETLOFT_WANT_TANGENT;
    if (t.want)
      if (const int status = f.evaluate(term, t); status != NETLOFT_OK) return status;
    if (request.values && moving && !matrix_here)
      if (const int status = call_matrix_term(f, term, t, request.matrix, w); status != NETLOFT_OK)
        return status;
  }
  return NETLOFT_OK;
}

/// Calls a term for a matrix other than its exact tangent: the convex part or the metric, which the term
/// offers or the host makes from the exact tangent, or the symmetric part of a full square.
int Assembler::call_matrix_term(const ElementFamily& f, const netloft_term& term, netloft_tile& t,
                                MatrixKind kind, Workspace& w) {
  const int dofs = f.type().dofs();
  const bool symmetric = term.traits & NETLOFT_SYMMETRIC;
  const auto n = static_cast<std::size_t>(dofs);
  const bool offered = (kind == MatrixKind::convex && (term.traits & NETLOFT_HAS_CONVEX)) ||
                       (kind == MatrixKind::metric && (term.traits & NETLOFT_HAS_METRIC));
  t.energy = nullptr;
  t.force = nullptr;
  t.want = offered ? want_of(kind) : std::uint32_t{NETLOFT_WANT_TANGENT};
  if (offered) {
    t.tangent = w.open_tangent(symmetric, n, t.count);
    return f.evaluate(term, t);
  }
  std::fill_n(w.scratch.begin(), (symmetric ? packed(n) : n * n) * kLanes, 0.0);
  t.tangent = w.scratch.data();
  if (const int status = f.evaluate(term, t); status != NETLOFT_OK) return status;
  double* triangle = w.open_tangent(true, n, t.count);
  if (kind == MatrixKind::exact) {
    add_symmetric_part(w.scratch.data(), n, triangle);
    return NETLOFT_OK;
  }
  if (kind == MatrixKind::metric) {
    add_bounds(w.scratch.data(), symmetric, n, t.count, triangle);
    return NETLOFT_OK;
  }
  for (std::size_t lane = 0; lane < t.count; ++lane) {
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) {
        const std::size_t entry = symmetric ? packed(std::max(r, c)) + std::min(r, c) : r * n + c;
        w.element[r * n + c] = w.scratch[entry * kLanes + lane];
      }
    project_convex(w.element.data(), dofs);
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c <= r; ++c) triangle[(packed(r) + c) * kLanes + lane] += w.element[r * n + c];
  }
  return NETLOFT_OK;
}

}  // namespace netloft
