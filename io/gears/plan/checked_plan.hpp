// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/read_plan.hpp"

namespace netloft::gears {

/// The messages whose proposals are tried (tried_cures.hpp): errors only, or warnings as well. A plan is read
/// and checked again for every trial; a run saves this work if its plan has only warnings.
enum class HintTrials { of_errors, of_all };

/// Reads a plan from its tables, checks whether the net can be sewn, and tries what the hints propose.
/// Warnings that the key `accept` names are marked as accepted. Parts stored in `memory` are taken over.
NetPlan read_and_check(const formats::Value& root, const Catalogue& catalogue, PlanMemory& memory,
                       HintTrials trials, formats::Diagnostics& diagnostics);

/// Reads and checks the plan in a file for use, with `overrides` applied. Entries of `accept` that match
/// nothing are reported.
NetPlan read_and_check(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       formats::Diagnostics& diagnostics);

/// Reads and checks a plan in memory, and tries all hints.
NetPlan read_and_check_text(const std::string& text, const std::string& name,
                            formats::Diagnostics& diagnostics);

}  // namespace netloft::gears
