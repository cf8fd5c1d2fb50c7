// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/workers.hpp"
#include "solvers/factorisation/front_kernels.hpp"

namespace netloft {

/// Eliminates a large front by (1) of front_kernels.hpp with several threads. The result has the same bits as
/// that of FrontKernels::eliminate, because the operations on every number are the same.
Elimination eliminate_together(const FrontKernels& kernels, const FrontPanels& front, const PivotRule& rule,
                               std::int32_t* exchanged, Workers& workers);

/// Computes the update (2) of front_kernels.hpp in the same way.
void update_together(const FrontKernels& kernels, const FrontPanels& front, double* C, Workers& workers);

}  // namespace netloft
