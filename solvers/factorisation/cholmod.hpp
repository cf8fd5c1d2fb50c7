// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

/// Width of CHOLMOD's indices: 64 bits in all cases, or as needed (64 bits only for factors with 2³¹ entries
/// or more, otherwise 32).
enum class IndexWidth { as_needed, of_64_bits };

/// Supernodal Cholesky factorisation of symmetric positive definite matrices, by CHOLMOD.
///   P A Pᵀ = L Lᵀ                                          (1)
///   x = Pᵀ L⁻ᵀ L⁻¹ P b                                     (2)
/// P orders the nodes; L is stored in dense blocks of columns (supernodes). From the second `factorise` on,
/// neither `factorise` nor `solve` allocates. If the matrix is not positive definite, `column` of the result
/// is the first unknown whose pivot in (1) is not positive; which unknown that is depends on P.
std::unique_ptr<Factorisation> make_cholmod_factorisation(OrderingMethod method = OrderingMethod::best);
std::unique_ptr<Factorisation> make_cholmod_factorisation_of(IndexWidth width,
                                                             OrderingMethod method = OrderingMethod::best);

}  // namespace netloft
