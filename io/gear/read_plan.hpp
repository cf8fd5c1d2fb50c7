// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/plan.hpp"

#include <filesystem>

namespace netloft::io {

/// Reads a gear with all it includes, `overrides` ("path=value") laid on top, and the catalogues that it
/// names parts of. Everything wrong with the writing is put into the diagnostics, located; whether the net
/// can be sewn is another question (check.hpp). After an error the plan holds what could be read.
Plan read_plan(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               Diagnostics& diagnostics);

/// The same for a text in memory.
Plan read_plan_text(const std::string& text, const std::string& name, Diagnostics& diagnostics);

}  // namespace netloft::io
