// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace netloft {

/// Opens a plugin in a process of its own and lets it describe itself there: opening a file runs its start-up
/// code. What would have become of this program: "crashed while it was opened (Segmentation fault)"; empty
/// when nothing would.
std::string fault_on_trial(const std::filesystem::path& file);

}  // namespace netloft
