// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"

#include <span>
#include <string>

namespace netloft {

enum class MarchStatus { finished, stopped, failed, out_of_time, out_of_work, interrupted };
const char* name_of(MarchStatus status);

/// A time as text: "0.25 s".
std::string seconds_text(double t);

/// Describes the fastest node, by the velocities v of the unknowns: "net node 4 moves at 3.2 m/s".
std::string fastest_node(const AssembledScene& of, std::span<const double> v);

}  // namespace netloft
