// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace netloft {

/// Opens a plugin in a separate process and reads all its tables there, because opening a plugin runs its
/// start-up code. The trial may take 20 s and 1 GiB of memory. The trial fails if the process ends, with
/// whatever exit code, before it reports. Returns an empty text if the trial succeeds, otherwise what
/// happened, such as "crashed while it was opened (Segmentation fault)". The process is forked at the first
/// trial, and again after a failed trial; a fork for each plugin would copy the page tables of the program
/// each time. A plugin that fails in a process in which others were opened before is tried again in a new
/// process.
std::string fault_on_trial(const std::filesystem::path& file);

}  // namespace netloft
