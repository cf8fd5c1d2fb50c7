// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/read_plan.hpp"

namespace netloft::gears {

/// The messages whose proposals are tried (tried_cures.hpp): errors only, or warnings as well. Each trial
/// reads and checks the plan again. A run tries proposals for errors only, and so makes no trials for a plan
/// that has only warnings.
enum class HintTrials { of_errors, of_all };

/// Reads a plan from its tables, checks whether the net can be sewn, and tries the proposals of hints.
/// Warnings named by the key `accept` are marked as accepted. Parts stored in `memory` are not read again.
NetPlan read_and_check(const formats::Value& root, const Catalogue& catalogue, PlanMemory& memory,
                       HintTrials trials, formats::Diagnostics& diagnostics);

/// Reads and checks the plan in a file, with `overrides` applied. Reports entries of `accept` that match
/// nothing.
NetPlan read_and_check(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       formats::Diagnostics& diagnostics);

/// Reads and checks a plan in memory, and tries all hints.
NetPlan read_and_check_text(const std::string& text, const std::string& name,
                            formats::Diagnostics& diagnostics);

}  // namespace netloft::gears
