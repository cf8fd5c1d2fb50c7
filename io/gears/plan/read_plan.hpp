// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/net_plan.hpp"

#include <filesystem>

namespace netloft::gears {

/// Reads a gear with all its includes, with `overrides` ("path=value") on top, and the catalogues with the
/// parts that it names. All errors of the text are put into the diagnostics with their places; check.hpp
/// checks whether the net can be sewn. After an error the plan contains whatever could be read.
NetPlan read_plan(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                  formats::Diagnostics& diagnostics);

/// Reads a plan from a document in memory: a scene that contains the tables of a plan. Other tables of the
/// scene are ignored, and so are the keys of `[gear]` about the model. `folder` is the base of `catalogue`.
NetPlan read_plan(const formats::Document& document, const std::filesystem::path& folder,
                  formats::Diagnostics& diagnostics);

/// Whether a document contains tables of a plan.
bool holds_plan(const formats::Document& document);

/// Reads a plan from a text in memory.
NetPlan read_plan_text(const std::string& text, const std::string& name, formats::Diagnostics& diagnostics);

/// Reads a plan from a text in memory with a given catalogue; a catalogue that the text names is not read.
NetPlan read_plan_text(const std::string& text, const std::string& name, const Catalogue& catalogue,
                       formats::Diagnostics& diagnostics);

}  // namespace netloft::gears
