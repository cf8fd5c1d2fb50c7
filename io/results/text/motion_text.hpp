// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace netloft::results {

/// The part of a report that is specific to motions: steps, start, accuracy, energies. Requires
/// result.motion.
std::string motion_text(const Result& result);
nlohmann::ordered_json motion_json(const Result& result);

/// Simulated time divided by wall time: above 1 the simulation is faster than real time.
double real_time_factor(const Result& result);

}  // namespace netloft::results
