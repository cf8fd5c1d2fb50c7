// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/gears/plan/plan_memory.hpp"

#include <filesystem>

namespace netloft::gears {

/// The tables of a plan, and the parts that it may name.
struct PlanDocument {
  formats::Value root;
  Catalogue catalogue;
  std::vector<formats::SourceFile> files;  // files of the document and of the catalogue

  /// Reads a file with all its includes, with `overrides` ("path=value") applied, and the catalogues; nullopt
  /// if there is an error in the file or in the overrides.
  static std::optional<PlanDocument> load(const std::filesystem::path& file,
                                          const std::vector<std::string>& overrides,
                                          formats::Diagnostics& diagnostics);
  /// Reads a text in memory.
  static std::optional<PlanDocument> parse(const std::string& text, const std::string& name,
                                           formats::Diagnostics& diagnostics);
};

/// Reads a gear with all its includes, with `overrides` ("path=value") applied, and the catalogues with the
/// parts that it names. All errors in the text go to the diagnostics with their places; check.hpp checks
/// whether the net can be sewn. After an error the plan contains whatever could be read.
NetPlan read_plan(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                  formats::Diagnostics& diagnostics);

/// Whether the root table of a document contains a plan, which has panels. A document without panels but with
/// other tables of a plan also counts as a plan (its panels are missing), unless it is a scene made of parts.
bool holds_plan(const formats::Value& root);

/// The tables of a scene on which its plan depends. Other tables, the keys of `[gear]` for the division into
/// elements, and the folders of catalogues are removed.
formats::Value tables_of_plan(formats::Value scene);

/// Reads the plan from tables that `tables_of_plan` returned, without a record of files.
NetPlan read_plan(const formats::Value& tables, const Catalogue& catalogue,
                  formats::Diagnostics& diagnostics);

/// Like read_plan() above, but does not read parts again that are in `memory`. The memory must belong to this
/// catalogue.
NetPlan read_plan(const formats::Value& tables, const Catalogue& catalogue, PlanMemory& memory,
                  formats::Diagnostics& diagnostics);

/// Reads a plan from a text in memory.
NetPlan read_plan_text(const std::string& text, const std::string& name, formats::Diagnostics& diagnostics);

/// Reads a plan from a text in memory with a given catalogue; a catalogue that the text names is not read.
NetPlan read_plan_text(const std::string& text, const std::string& name, const Catalogue& catalogue,
                       formats::Diagnostics& diagnostics);

}  // namespace netloft::gears
