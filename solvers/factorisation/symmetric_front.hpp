// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/workers.hpp"
#include "solvers/factorisation/front_kernels.hpp"

namespace netloft {

/// (1) and (3) of front_kernels.hpp for a front of a positive definite matrix, from the lower triangle of A₁₁
/// and from A₂₁, by this thread or by all `workers`, with the same bits. It takes half of the operations of L
/// U. It stops at a pivot that is not positive.
Elimination eliminate_symmetric(const FrontKernels& kernels, const FrontPanels& front,
                                std::int32_t* exchanged, Workers* workers);

/// (2) in the lower triangle, and here and there above it.
void update_symmetric(const FrontKernels& kernels, const FrontPanels& front, double* C, Workers* workers);

}  // namespace netloft
