// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

/// Multifrontal LU factorisation of matrices that are not symmetric, by UMFPACK.
///   P (R A) Q = L U                                        (1)
/// R scales the rows. The pattern should be nearly symmetric: Q orders the nodes of A + Aᵀ, and the diagonal
/// entry is the pivot unless it is small. There is no iterative refinement, because Newton's iteration has
/// the same effect. A pivot of exactly zero is reported as singular; a pivot that is only round-off passes.
std::unique_ptr<Factorisation> make_umfpack_factorisation(OrderingMethod method = OrderingMethod::best);

}  // namespace netloft
