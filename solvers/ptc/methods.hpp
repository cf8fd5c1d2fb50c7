// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/ptc/ptc.hpp"

namespace netloft::ptc {

Outcome solve_linearly_implicitly(const PseudoTransient::Parameters& parameters, Problem& problem);
Outcome solve_implicitly(const PseudoTransient::Parameters& parameters, Problem& problem);

}  // namespace netloft::ptc
