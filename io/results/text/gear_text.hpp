// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/run_result.hpp"

namespace netloft::results {

/// Whether figures are those of a net plan, beside those of rigid bodies, which come first.
bool are_of_plan(const std::vector<NamedScalar>& figures);

/// A table of figures as people read it, in whatever medium: a row for each part, rope or body.
struct FigureTable {
  struct Row {
    std::string name;
    std::vector<std::string> cells;  // "-" where a number is not known
  };
  std::string title;
  std::vector<std::string> headings;  // of the cells
  std::vector<Row> rows;
};

/// A principal figure, in the unit in which its trade speaks of it.
struct PrincipalFigure {
  std::string name;  // "headline height"
  NamedScalar figure;
};

/// All that a report says of a gear, in its order. Text, page and HTML have the same.
struct GearTables {
  std::vector<FigureTable> bodies;
  std::vector<PrincipalFigure> principal;
  std::vector<FigureTable> gear;
};
GearTables gear_tables(const std::vector<NamedScalar>& figures, bool is_half);

inline constexpr const char* kOfHalf =
    "one half was modelled; areas, masses, weights and forces aft and upwards are those of the whole gear";

/// The figures of a gear as tables for people; empty if there are none. `is_half`: only one half of the gear
/// was modelled.
std::string gear_text(const std::vector<NamedScalar>& figures, bool is_half);

/// What a principal figure is called in a table, "headline height" for "mouth/headline_height"; empty: it is
/// none.
std::string principal_name(const std::string& figure);

/// The error of a number, of solver and mesh together; NaN unless both are known, because the error of the
/// mesh is by far the larger one as a rule.
double total_error(const NamedScalar& scalar);

/// The sentences of a note on meshes, each on a line of its own that is indented.
std::string mesh_note_text(std::string note);

/// That error as "± 1.3e-02", or "±?" where it is not known.
std::string error_text(const NamedScalar& scalar);

/// Both errors of a number in the form "± 2.1e-12 ± 1.3e-02 (order 1.1)": that of the solver and that of the
/// mesh.
std::string errors_text(const NamedScalar& scalar);

}  // namespace netloft::results
