// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>

#include "framework/balance/factorisation.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

using MakeSpare = std::function<std::unique_ptr<Factorisation>()>;

/// Multifrontal factorisation of matrices that are not symmetric and nearly so in pattern, front by front in
/// a fixed order (front_tree.hpp).
///   P A Pᵀ = Q L U                                         (1)
///   ω = max |b − A x|ᵢ / (|A| |x| + |b|)ᵢ                  (2)
/// P orders the nodes, Q exchanges rows within the pivots of a front, and no others. All is laid out in
/// `analyse`, and nothing is scaled, sorted or delayed afterwards: what other codes do so costs more than the
/// arithmetic where matrices have some thousand unknowns. The price is that pivots may be poor. So a matrix
/// goes to the factorisation that `make_spare` makes
/// - if a pivot is zero, or less than 1e-8 of what is below it beyond the pivots of its front;
/// - if in the first solve after a factorisation the backward error (2) of Oettli and Prager (1964) is larger
///   than 1e-9 even after a step of iterative refinement.
/// Several threads eliminate what is large (front_schedule.hpp), with the same bits for any number of them.
/// A column of zeros makes the matrix singular at its unknown. From the second `factorise` on neither
/// `factorise` nor `solve` allocates while the spare has nothing to do.
std::unique_ptr<Factorisation> make_multifrontal_factorisation(MakeSpare make_spare,
                                                               OrderingMethod method = OrderingMethod::best,
                                                               int threads = 1);

}  // namespace netloft
