// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/ptc/ptc.hpp"

namespace netloft::ptc {

/// δ stays between these, the square root of the machine's epsilon and its inverse: K is lost beside M/δ for
/// most of its digits, or M/δ beside K.
constexpr double kShortestStep = 0x1p-26, kLongestStep = 0x1p52;

Outcome solve_linearly_implicitly(const PseudoTransient::Parameters& parameters, Problem& problem);
Outcome solve_implicitly(const PseudoTransient::Parameters& parameters, Problem& problem);

}  // namespace netloft::ptc
