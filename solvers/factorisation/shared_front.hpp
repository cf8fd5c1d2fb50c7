// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/workers.hpp"
#include "solvers/factorisation/front_kernels.hpp"

namespace netloft {

/// (1) of front_kernels.hpp by several threads, for large fronts: the same operations on every number as
/// FrontKernels::eliminate, and so the same bits.
Elimination eliminate_together(const FrontKernels& kernels, const FrontPanels& front, double least_pivot,
                               std::int32_t* exchanged, Workers& workers);

/// (2), likewise.
void update_together(const FrontKernels& kernels, const FrontPanels& front, double* C, Workers& workers);

}  // namespace netloft
