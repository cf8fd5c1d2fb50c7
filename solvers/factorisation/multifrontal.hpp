// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>

#include "framework/balance/factorisation.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

using MakeSpare = std::function<std::unique_ptr<Factorisation>()>;

/// Multifrontal factorisation of unsymmetric matrices A with a nearly symmetric pattern, front by front in a
/// fixed order (front_tree.hpp), and the backward error of a solution x of A x = b:
///   P A Pᵀ = Q L U                                         (1)
///   ω = max |b − A x|ᵢ / (|A| |x| + |b|)ᵢ                  (2)
/// P orders the nodes; Q exchanges rows only among the pivots of a front. `analyse` plans everything; nothing
/// is scaled, sorted or delayed afterwards. (In other codes, such operations take longer than the arithmetic
/// if a matrix has only some thousand unknowns.) The disadvantage is that pivots may be poor. Therefore the
/// spare factorisation, which `make_spare` makes, takes over
/// - if a pivot is zero, or less than 1e-8 of the entries below it outside the pivots of its front;
/// - if in the first solve after a factorisation the backward error (2) (Oettli and Prager 1964) is larger
///   than 1e-9 even after a step of iterative refinement.
/// Without a spare factorisation, a matrix with such a pivot counts as singular. A column of zeros is
/// reported as singular at its unknown. Several threads eliminate large matrices (front_schedule.hpp), with
/// the same bits for any number of threads. From the second `factorise` on, neither `factorise` nor `solve`
/// allocates unless the spare factorisation takes over.
std::unique_ptr<Factorisation> make_multifrontal_factorisation(MakeSpare make_spare,
                                                               OrderingMethod method = OrderingMethod::best,
                                                               int threads = 1);

/// The same for symmetric positive definite matrices, which are given by their lower triangle: Q = 1, and the
/// diagonal of U is positive. A pivot that is mere rounding counts as zero. If the matrix is not positive
/// definite, `column` of the result is the first unknown, in the order P, whose pivot is not positive.
std::unique_ptr<Factorisation> make_definite_factorisation(OrderingMethod method = OrderingMethod::best,
                                                           int threads = 1);

}  // namespace netloft
