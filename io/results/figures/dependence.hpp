// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/make_result.hpp"

namespace netloft::results {

/// Completes the numbers of a result: their solver errors, their range over all equilibria that were found,
/// and their change with a growing motion.
void add_dependence(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution,
                    Result& result);

}  // namespace netloft::results
