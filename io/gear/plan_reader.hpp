// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/catalogue/catalogue.hpp"
#include "io/gear/plan.hpp"
#include "io/toml/table_reader.hpp"

namespace netloft::io {

/// A part that a plan names, or writes out.
struct ChosenPart {
  std::string name;  // of the catalogue; empty: written out
  Value table;
};

/// What stands under `key`, of the catalogue's kinds for `kind_key`.
ChosenPart read_part_choice(TableReader& table, const char* key, const char* kind_key,
                            const Catalogue& catalogue);

/// Reads tables of a plan. Members are those of the plan, a file each.
Panel read_panel(const std::string& name, TableReader& table, const Catalogue& catalogue);
Rope read_rope(const std::string& name, TableReader& table, const Catalogue& catalogue);
Hanging read_hanging(TableReader& table);
Join read_join(TableReader& table);
Pieces read_pieces(const std::string& name, TableReader& table, const Catalogue& catalogue);
Point read_point(const std::string& name, TableReader& table);

/// Gathers what seams take of their edges: outlines become narrower, and the strip is a rope on the edge.
void add_selvedges(Plan& plan, Diagnostics& diagnostics);

/// `stands = "pair"`.
Standing read_standing(TableReader& table, const char* fallback);

}  // namespace netloft::io
