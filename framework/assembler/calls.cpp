// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/calls.hpp"

#include "framework/assembler/projection.hpp"

#include <algorithm>

namespace netloft {

namespace {

/// Adds the symmetric part of a square tangent to a packed lower triangle.
void add_symmetric_part(const double* __restrict square, std::size_t n, double* __restrict packed_tangent) {
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c <= r; ++c) {
      const double *here = square + (r * n + c) * kTileLanes, *there = square + (c * n + r) * kTileLanes;
      double* to = packed_tangent + (packed(r) + c) * kTileLanes;
      for (std::size_t lane = 0; lane < kTileLanes; ++lane) to[lane] += 0.5 * (here[lane] + there[lane]);
    }
}

/// Adds the convex part of each element's tangent (project_convex) to the packed `triangle`. The tangents are
/// in the scratch rows.
void add_convex_parts(std::size_t n, bool symmetric, std::size_t count, TileSums& sums, double* triangle) {
  for (std::size_t lane = 0; lane < count; ++lane) {
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) {
        const std::size_t entry = symmetric ? packed(std::max(r, c)) + std::min(r, c) : r * n + c;
        sums.element[r * n + c] = sums.scratch[entry * kTileLanes + lane];
      }
    project_convex(sums.element.data(), static_cast<int>(n));
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c <= r; ++c)
        triangle[(packed(r) + c) * kTileLanes + lane] += sums.element[r * n + c];
  }
}

/// Adds the matrix of a term if it is not the exact tangent: the convex part, the metric (ext/convex.h), or,
/// if the matrix is symmetric, the symmetric part of an unsymmetric tangent. A term that offers the convex
/// part or the metric computes this matrix itself; otherwise the matrix is derived from the exact tangent of
/// the term.
int call_matrix_term(const ElementFamily& f, const netloft_term& term, netloft_tile& t, MatrixKind kind,
                     TileSums& sums) {
  const bool symmetric = term.traits & NETLOFT_SYMMETRIC;
  const auto n = static_cast<std::size_t>(f.type().dofs());
  const bool offered = (kind == MatrixKind::convex && (term.traits & NETLOFT_HAS_CONVEX)) ||
                       (kind == MatrixKind::metric && (term.traits & NETLOFT_HAS_METRIC));
  t.energy = nullptr;
  t.force = nullptr;
  t.want = NETLOFT_WANT_TANGENT;
  if (offered) {
    t.want = kind == MatrixKind::convex ? NETLOFT_WANT_CONVEX : NETLOFT_WANT_METRIC;
    t.tangent = sums.open_tangent(symmetric, n, t.count);
    return f.evaluate(term, t);
  }
  std::fill_n(sums.scratch.begin(), (symmetric ? packed(n) : n * n) * kTileLanes, 0.0);
  t.tangent = sums.scratch.data();
  if (const int status = f.evaluate(term, t); status != NETLOFT_OK) return status;
  double* triangle = sums.open_tangent(true, n, t.count);
  if (kind == MatrixKind::exact)
    add_symmetric_part(sums.scratch.data(), n, triangle);
  else if (kind == MatrixKind::metric)
    add_bounds(sums.scratch.data(), symmetric, n, t.count, triangle);
  else
    add_convex_parts(n, symmetric, t.count, sums, triangle);
  return NETLOFT_OK;
}

}  // namespace

int TermCalls::call(const ElementFamily& f, bool with_energy, netloft_tile& t, const Request& request,
                    TileSums& sums) const {
  if (const int status = call_each(f, f.active_terms(), with_energy, t, request, sums); status != NETLOFT_OK)
    return status;
  const bool by_rates = request.values && request.matrix == MatrixKind::exact &&
                        (request.motion.cv != 0 || request.motion.ca != 0);
  return by_rates ? call_each(f, f.terms_of_motion(), with_energy, t, request, sums) : NETLOFT_OK;
}

int TermCalls::call_each(const ElementFamily& f, const std::vector<netloft_term>& terms, bool with_energy,
                         netloft_tile& t, const Request& request, TileSums& sums) const {
  for (const auto& term : terms) {
    const bool conservative = term.traits & NETLOFT_CONSERVATIVE;
    if (conservative != with_energy || (term.traits & request.without)) continue;
    if (const int status = call_term(f, term, t, request, sums); status != NETLOFT_OK) return status;
  }
  return NETLOFT_OK;
}

int TermCalls::call_term(const ElementFamily& f, const netloft_term& term, netloft_tile& t,
                         const Request& request, TileSums& sums) const {
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  const bool symmetric = term.traits & NETLOFT_SYMMETRIC;
  const bool in_matrix = request.values && counts_in_matrix(term);
  const bool matrix_here = in_matrix && request.matrix == MatrixKind::exact &&
                           (symmetric || (tangent_ == TangentChoice::exact && !symmetric_));
  t.energy = request.energy && (term.traits & NETLOFT_CONSERVATIVE) ? sums.energy : nullptr;
  t.force = request.residual ? sums.force.open(dofs, t.count) : nullptr;
  t.tangent = matrix_here ? sums.open_tangent(symmetric, dofs, t.count) : nullptr;
  t.want = 0;
  if (t.energy) t.want |= NETLOFT_WANT_ENERGY;
  if (t.force) t.want |= NETLOFT_WANT_FORCE;
  if (t.tangent) t.want |= NETLOFT_WANT_TANGENT;
  if (t.want)
    if (const int status = f.evaluate(term, t); status != NETLOFT_OK) return status;
  if (!in_matrix || matrix_here) return NETLOFT_OK;
  return call_matrix_term(f, term, t, request.matrix, sums);
}

/// Whether a term contributes to the matrix. Constant forces have no tangent. TangentChoice::elastic leaves
/// out forces that have no potential (drag, pressure). It keeps inertia, without which the matrix of a time
/// step would be singular.
bool TermCalls::counts_in_matrix(const netloft_term& term) const {
  if (term.traits & NETLOFT_CONSTANT) return false;
  return (term.traits & (NETLOFT_CONSERVATIVE | NETLOFT_READS_ACCELERATION)) ||
         tangent_ != TangentChoice::elastic;
}

}  // namespace netloft
