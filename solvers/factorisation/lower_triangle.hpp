// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Makes a factorisation of symmetric matrices of which only the lower triangle is given, from a
/// factorisation `inner` that needs all entries.
std::unique_ptr<Factorisation> make_factorisation_of_lower_triangle(std::unique_ptr<Factorisation> inner);

}  // namespace netloft
