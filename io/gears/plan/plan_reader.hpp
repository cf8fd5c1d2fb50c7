// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/net_plan.hpp"

namespace netloft::gears {

inline constexpr double kMostMeshes = 1e5;  // across or along a panel

/// A part that a plan names from a catalogue or writes itself.
struct ChosenPart {
  std::string name;  // in the catalogue; empty: written in the plan
  formats::Value table;
};

/// Reads the part under `key`: a name of the catalogue's kinds for `kind_key`, or a table.
ChosenPart read_part_choice(formats::TableReader& table, const char* key, const char* kind_key,
                            const Catalogue& catalogue);

/// Reads tables of a plan. The members of a plan are read in a file each.
Panel read_panel(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
/// Reads counts and sides of a panel from its corners, `corners = [[0, 0], [20, 0], [15, 10]]`.
void read_corners(Panel& panel, formats::TableReader& table);
Rope read_rope(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
Hanging read_hanging(formats::TableReader& table);
Join read_join(formats::TableReader& table);
Pieces read_pieces(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
Point read_point(const std::string& name, formats::TableReader& table);

/// Reads the symmetry of a body and its points, its own or those of the board that it names.
PlanBody read_plan_body(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
/// `[ship]`: adds its blocks and warps to the plan, whose bodies are known.
void add_ship(NetPlan& plan, formats::TableReader& ship, const Catalogue& catalogue);

/// Reads `winch` of a warp whose lengths and tensions are known: one table, or a list of successive tables.
void read_winch(formats::TableReader& warp, Rope& rope);

/// Adds the selvedges that seams gather: outlines become narrower, and each strip becomes a rope on the edge.
void add_selvedges(NetPlan& plan, formats::Diagnostics& diagnostics);

/// Reads the symmetry of a part, `stands = "pair"`.
Standing read_standing(formats::TableReader& table, const char* fallback);

}  // namespace netloft::gears
