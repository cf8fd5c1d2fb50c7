// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/text/measured.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// A table of figures, printed as text or HTML: a row for each part, rope or body.
struct FigureTable {
  struct Row {
    std::string name;
    std::vector<std::string> cells;  // "-" where a number is not known
  };
  std::string title;
  std::vector<std::string> headings;  // headings of the cells
  std::vector<Row> rows;
  bool is_for_deck = false;  // whether it is about boards and warps, which skippers read first
  std::string note = {};     // a line below the rows
};

/// A figure that a report shows first, in the unit that is usual in fisheries.
struct PrincipalFigure {
  std::string name;         // such as "headline height"
  std::string value, unit;  // such as "0.41 ± 0.06" and "m"
  std::string doc;
};

/// Converts a figure to the unit that is usual in fisheries, such as kW for W.
NamedScalar in_spoken_unit(NamedScalar figure);

std::vector<PrincipalFigure> principal_figures(const std::vector<NamedScalar>& figures);

/// Adds the tables of a gear: bodies, ropes, netting, forces.
void add_gear_tables(const std::vector<NamedScalar>& figures, bool is_half, std::vector<FigureTable>& tables);

inline constexpr const char* kOfHalf =
    "one half was modelled; areas, masses, weights and forces aft and upwards are those of the whole gear";

/// The panels that have to be cut, as a table.
FigureTable netting_table(const std::vector<scenes::NettingSheet>& netting);

std::string table_text(const FigureTable& table);

}  // namespace netloft::results
