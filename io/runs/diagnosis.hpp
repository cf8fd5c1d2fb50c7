// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"

#include <string>
#include <vector>

namespace netloft::runs {

/// Describes a point that is no equilibrium, in sentences about parts by name:
///   slack         no element of the part has tension, so that nothing holds it in its place
///   pressed       elements bear compression, and the gear may be balanced on them
///   folded        neighbours in a part are turned back on one another
///   gone          the part that moved furthest, if that is further than the gear is long
/// It uses outputs of elements ("tension") only, so that it works for parts of any plugin.
std::vector<std::string> diagnose(const Scene& scene, Assembler& assembler, const Solution& solution);

}  // namespace netloft::runs
