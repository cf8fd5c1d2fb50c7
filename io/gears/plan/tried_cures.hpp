// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"

namespace netloft::gears {

/// How much work may go into trying proposals. Each trial checks the whole plan again, so a plan of a hundred
/// thousand parts gets only a few trials, and a usual plan as many as it needs.
struct CureLimits {
  std::size_t most = 400;           // trials for all messages of a plan
  std::size_t least = 5;            // trials of a plan of any size
  std::size_t part_trials = 40000;  // trials times the parts of the plan
  std::size_t alternatives = 3;     // proposals that a hint may offer to choose from
  std::size_t steps = 3;            // values that a proposal may change one after another
};

/// Tries the proposals (Diagnostic::cures) of all messages about a plan: applies each to a copy of `root`,
/// the tables that the plan was read from, and reads and checks the copy. A hint then begins with the values
/// after which the message disappears and no other appears; or else with values that need others, and with
/// those; or else with values and with what is still wrong after them. Accepted warnings need no proposals.
void try_cures(const formats::Value& root, const Catalogue& catalogue, formats::Diagnostics& diagnostics,
               const CureLimits& limits = {});

}  // namespace netloft::gears
