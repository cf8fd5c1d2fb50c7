// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/motion/motion_run.hpp"

namespace netloft::results {

/// The result of a motion, for people and for programs (one JSON object).
std::string motion_text(const scenes::LoadedScene& loaded, const ScenePlan& plan, const MotionResult& result);
std::string motion_json(const scenes::LoadedScene& loaded, const ScenePlan& plan, const MotionResult& result);

/// Simulated time divided by wall time: above 1 the simulation is faster than real time.
double real_time_factor(const MotionResult& result);

}  // namespace netloft::results
