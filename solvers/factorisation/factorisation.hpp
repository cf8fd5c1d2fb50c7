// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/problem/factorisation.hpp"

namespace netloft {

/// The factorisation to use for a pattern: CHOLMOD for symmetric positive definite matrices, UMFPACK for the
/// others. Fits `MakeFactorisation`.
std::unique_ptr<Factorisation> make_factorisation(bool symmetric);

}  // namespace netloft
