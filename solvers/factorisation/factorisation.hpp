// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/problem/factorisation.hpp"

namespace netloft {

/// The factorisation to use: CHOLMOD for positive definite matrices, our own multifrontal one for unsymmetric
/// ones, MUMPS for the others and for what our own hands over, or UMFPACK where there is no MUMPS. Fits
/// `MakeFactorisation`.
std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind);

}  // namespace netloft
