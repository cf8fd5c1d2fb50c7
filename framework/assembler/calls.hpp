// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"
#include "framework/assembler/request.hpp"
#include "framework/assembler/tile_sums.hpp"

namespace netloft {

/// Calls the terms of a family (all elements of one type) on a tile of 64 elements, and adds the results to
/// the sums that a request asks for. If a term does not offer the requested matrix, the matrix is derived
/// from the exact tangent of the term (projection.hpp).
class TermCalls {
 public:
  /// `symmetric`: the matrix holds its lower triangle only.
  TermCalls(TangentChoice tangent, bool symmetric) : tangent_(tangent), symmetric_(symmetric) {}

  /// Calls either the conservative terms (`with_energy`) or all other terms. Callers begin with the
  /// conservative terms, so that the gradient of the energy has the same bits whether or not the other terms
  /// follow. Returns the first status other than NETLOFT_OK.
  int call(const ElementFamily& family, bool with_energy, netloft_tile& tile, const Request& request,
           TileSums& sums) const;

 private:
  int call_each(const ElementFamily& family, const std::vector<netloft_term>& terms, bool with_energy,
                netloft_tile& tile, const Request& request, TileSums& sums) const;
  int call_term(const ElementFamily& family, const netloft_term& term, netloft_tile& tile,
                const Request& request, TileSums& sums) const;
  bool counts_in_matrix(const netloft_term& term) const;

  TangentChoice tangent_;
  bool symmetric_;
};

}  // namespace netloft
