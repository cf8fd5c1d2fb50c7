// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Makes the factorisation for a class of matrices: this program's multifrontal factorisation for positive
/// definite matrices and for unsymmetric ones, for these with MUMPS as its fallback, and MUMPS for all
/// others. Without MUMPS, there is no fallback, and the multifrontal factorisation takes all matrices. Fits
/// `MakeFactorisation`.
std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind);

/// Returns a function like make_factorisation that uses `threads` threads for large matrices. The factors
/// have the same bits for any number of threads.
MakeFactorisation make_factorisation_with(int threads);

}  // namespace netloft
