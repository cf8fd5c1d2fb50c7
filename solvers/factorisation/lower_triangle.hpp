// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/problem/factorisation.hpp"

namespace netloft {

/// Lets `inner`, which wants all entries, factorise symmetric matrices of which the lower triangle is given.
std::unique_ptr<Factorisation> make_factorisation_of_lower_triangle(std::unique_ptr<Factorisation> inner);

}  // namespace netloft
