// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Makes the factorisation for a class of matrices. Positive definite matrices get our multifrontal
/// factorisation; unsymmetric matrices get it with MUMPS as the fallback; all other matrices get MUMPS. In a
/// build without MUMPS, all matrices get the multifrontal factorisation, without a fallback. The function has
/// the type `MakeFactorisation`.
std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind);

/// Returns a function like make_factorisation that uses `threads` threads for large matrices. The factors
/// have the same bits for any number of threads.
MakeFactorisation make_factorisation_with(int threads);

}  // namespace netloft
