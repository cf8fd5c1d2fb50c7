// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"

#include <string>
#include <vector>

namespace netloft::runs {

/// Describes a point that is no equilibrium, in sentences about parts by name:
///   slack         no element of the part has tension, so that nothing holds the part in place
///   pressed       elements are in compression, and the gear may be balanced on them
///   folded        neighbouring elements of a part are turned back on one another
///   gone          the part that moved furthest, if it moved further than the gear is long
/// Only outputs of elements ("tension") are used, so that this works for parts of any plugin.
std::vector<std::string> diagnose(const Scene& scene, Assembler& assembler, const Solution& solution);

}  // namespace netloft::runs
