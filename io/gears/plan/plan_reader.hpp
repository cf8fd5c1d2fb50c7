// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/net_plan.hpp"

namespace netloft::gears {

inline constexpr double kMostMeshes = 1e5;  // largest number of meshes across or along a panel

/// A part that a plan names from a catalogue, or describes by numbers of its own.
struct ChosenPart {
  std::string name;  // name in the catalogue; empty if the plan states the numbers
  formats::Value table;
};

/// Reads the part under `key`: a table, or the name of a catalogue part of the kinds that `kind_key` allows.
ChosenPart read_part_choice(formats::TableReader& table, const char* key, const char* kind_key,
                            const Catalogue& catalogue);

/// These functions read the tables of a plan. Each of them has its own source file.
Panel read_panel(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
/// Reads counts and sides of a panel from its corners, `corners = [[0, 0], [20, 0], [15, 10]]`.
void read_corners(Panel& panel, formats::TableReader& table);
Rope read_rope(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
Hanging read_hanging(formats::TableReader& table);
Join read_join(formats::TableReader& table);
Pieces read_pieces(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
Point read_point(const std::string& name, formats::TableReader& table);

/// Reads the symmetry of a body and the names of its points, from the table of the body or from the catalogue
/// board that this table names.
PlanBody read_plan_body(const std::string& name, formats::TableReader& table, const Catalogue& catalogue);
/// Reads `[ship]`, and adds its blocks and warps to the plan. The bodies of the plan must be known.
void add_ship(NetPlan& plan, formats::TableReader& ship, const Catalogue& catalogue);

/// Reads `winch` of a warp, after the lengths and tensions of the warp: one table, or a list of tables, each
/// of which replaces the previous one at its first time.
void read_winch(formats::TableReader& warp, Rope& rope);

/// Models the meshes that seams gather: makes outlines narrower by these meshes, and adds ropes along the
/// edges, whose stiffness and mass are those of the gathered meshes.
void add_selvedges(NetPlan& plan, formats::Diagnostics& diagnostics);

Standing read_standing(formats::TableReader& table, const char* fallback);

}  // namespace netloft::gears
