// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"

namespace netloft::gears {

/// How much work may go into trying proposals. Each trial checks the whole plan again, so a plan of a hundred
/// thousand parts gets only a few trials, and a usual plan as many as it needs.
struct CureLimits {
  std::size_t most = 400;           // trials for all messages of a plan
  std::size_t least = 5;            // trials of a plan of any size
  std::size_t part_trials = 40000;  // limit of the number of trials times the number of parts of the plan
  std::size_t alternatives = 3;     // alternatives that a hint may offer
  std::size_t steps = 3;            // number of values that a proposal may change one after another
};

/// Tries the proposals (Diagnostic::cures) of all messages about a plan: applies each to a copy of `root`,
/// the tables of the plan, and reads and checks the copy. If values remove a message and cause no other, its
/// hint begins with them. Otherwise the hint begins with values and the further values that these require, or
/// with values and the errors that remain. Accepted warnings need no proposals.
void try_cures(const formats::Value& root, const Catalogue& catalogue, formats::Diagnostics& diagnostics,
               const CureLimits& limits = {});

}  // namespace netloft::gears
