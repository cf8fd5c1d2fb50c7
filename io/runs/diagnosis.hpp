// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"

#include <string>
#include <vector>

namespace netloft::runs {

/// Describes the last point of a search that found no equilibrium. Each sentence names a part and one fault:
///   slack         no element of the part has tension, so that nothing keeps the part in place
///   pressed       elements are in compression, and the gear may be balanced on them
///   folded        neighbouring elements of a part are turned back on one another
///   gone          the node that moved furthest, if it moved more than twice the size of the gear
/// Tensions are the element outputs that are declared as tensions, so that this works for parts of any
/// plugin.
std::vector<std::string> diagnose(const Scene& scene, Assembler& assembler, const Solution& solution);

}  // namespace netloft::runs
