// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace netloft {

/// Opens a plugin in a process of its own and lets it describe itself there, down to the last word of its
/// tables: opening a file runs its start-up code. That process has 20 s and 1 GiB of memory, and must come to
/// its end: one that leaves early, with whatever exit code, has failed. What would have become of this
/// program: "crashed while it was opened (Segmentation fault)"; empty when nothing would. The process is
/// forked at the first trial, and again after one that failed: a fork for each plugin would copy the page
/// tables of the program each time. A plugin that fails beside others is tried once more alone.
std::string fault_on_trial(const std::filesystem::path& file);

}  // namespace netloft
