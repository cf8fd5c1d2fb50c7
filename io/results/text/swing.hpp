// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/run_result.hpp"

#include <nlohmann/json.hpp>

namespace netloft::results {

/// How every number changes with the motion that grows about a swinging or unstable equilibrium, for each
/// metre that its furthest node moves, as a table for people: what the scene asks for, and the principal
/// figures of a gear. Empty where nothing grows.
std::string swing_text(const std::string& furthest, const std::vector<NamedScalar>& scalars,
                       const std::vector<NamedScalar>& gear);

/// {"furthest", "tenfold_in" [s], "period" [s], "per_metre"} of what the scene asks for; null where nothing
/// grows, and `period` null where it does not swing. The figures of a gear follow in `per_metre` by their own
/// names.
nlohmann::ordered_json swing_json(const RunResult& result);

}  // namespace netloft::results
