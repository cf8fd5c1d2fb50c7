// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/dynamics/motion_run.hpp"

namespace netloft::io {

/// What came of a motion, for a person and for a program (one JSON object).
std::string motion_text(const LoadedScene& loaded, const Plan& plan, const MotionResult& result);
std::string motion_json(const LoadedScene& loaded, const Plan& plan, const MotionResult& result);

/// Simulated time over wall time: above 1 it is faster than what it shows.
double real_time_factor(const MotionResult& result);

}  // namespace netloft::io
