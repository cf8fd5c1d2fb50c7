// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/catalogue/catalogue.hpp"
#include "io/gear/plan.hpp"

#include <filesystem>

namespace netloft::io {

/// Reads a gear with all it includes, `overrides` ("path=value") laid on top, and the catalogues that it
/// names parts of. Everything wrong with the writing is put into the diagnostics, located; whether the net
/// can be sewn is another question (check.hpp). After an error the plan holds what could be read.
Plan read_plan(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               Diagnostics& diagnostics);

/// The same of a document that is there already: a scene that holds the tables of a plan beside its own. What
/// else a scene may hold is passed over, and the keys of `[gear]` that say how it is modelled. `folder` is
/// what `catalogue` is relative to.
Plan read_plan(const Document& document, const std::filesystem::path& folder, Diagnostics& diagnostics);

/// Whether a document holds tables of a plan.
bool holds_plan(const Document& document);

/// The same for a text in memory.
Plan read_plan_text(const std::string& text, const std::string& name, Diagnostics& diagnostics);

/// The same with parts of a catalogue at hand; one that the text names is not read.
Plan read_plan_text(const std::string& text, const std::string& name, const Catalogue& catalogue,
                    Diagnostics& diagnostics);

}  // namespace netloft::io
