// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"

#include <string>
#include <vector>

namespace netloft::runs {

/// What is to be seen where a solver ended without an equilibrium, as sentences about parts by name:
///   slack         no element of the part has tension, so that nothing holds it in its place
///   pressed       elements bear compression that counts, and the gear may stand where it would fall
///   folded        neighbours of a part lie back on one another
///   gone          the part that moved furthest, if that is further than the gear is long
/// In words of what elements put out ("tension"), so that parts of any plugin are understood.
std::vector<std::string> diagnose(const Scene& scene, Assembler& assembler, const Solution& solution);

}  // namespace netloft::runs
