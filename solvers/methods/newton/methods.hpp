// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/methods/newton/newton.hpp"

namespace netloft::newton {

Outcome solve_classic(Problem& problem);
Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem);

}  // namespace netloft::newton
