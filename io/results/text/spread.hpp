// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/run_result.hpp"

#include <nlohmann/json.hpp>

namespace netloft::results {

/// The least and the largest value of every number over the equilibria that were found, as a table for
/// people: what the scene asks for, and the principal figures of a gear. Empty where one equilibrium was
/// found.
std::string spread_text(const std::vector<NamedScalar>& scalars, const std::vector<NamedScalar>& gear);

/// The same of all numbers, by name, as {"least", "largest"}; null where one equilibrium was found.
nlohmann::ordered_json spread_json(const std::vector<NamedScalar>& scalars);

}  // namespace netloft::results
