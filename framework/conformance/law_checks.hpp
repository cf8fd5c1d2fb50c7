// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/checks.hpp"
#include "framework/conformance/law_bench.hpp"

namespace netloft::conformance {

// Derivatives: is the force without kinks, and are its derivatives correct? (law_derivative_checks.cpp)
Finding law_has_no_kink(LawBench&);
Finding d_flow_is_derivative(LawBench&);
Finding d_direction_is_derivative(LawBench&);
Finding d_solidity_is_derivative(LawBench&);

// Physics: is the force one that water can exert? (law_flow_checks.cpp)
Finding law_needs_flow(LawBench&);
Finding law_never_gains_energy(LawBench&);
Finding rotation_turns_the_force_of_a_law(LawBench&);
Finding law_is_odd_in_flow(LawBench&);
Finding law_is_even_in_direction(LawBench&);

}  // namespace netloft::conformance
