// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/make_result.hpp"

namespace netloft::results {

/// Adds two properties to every number of a result: the solver error, and the range over all equilibria that
/// were found. At an unstable equilibrium, also adds the change of the number along the motion that grows.
void add_dependence(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution,
                    Result& result);

}  // namespace netloft::results
