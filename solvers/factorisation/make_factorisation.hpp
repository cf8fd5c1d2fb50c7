// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Makes the factorisation for a class of matrices: our own multifrontal factorisation for positive definite
/// and for unsymmetric matrices, with MUMPS as the fallback for unsymmetric ones, and MUMPS for all others.
/// Without MUMPS, there is no fallback, and the multifrontal factorisation takes all matrices. Fits
/// `MakeFactorisation`.
std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind);

/// Returns a function like make_factorisation that uses `threads` threads for large matrices. The factors
/// have the same bits for any number of threads.
MakeFactorisation make_factorisation_with(int threads);

}  // namespace netloft
