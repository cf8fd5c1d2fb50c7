// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/result_tables.hpp"

#include "io/results/figures/figure_names.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::results {

namespace {

using Cells = std::vector<std::string>;

/// Adds a table with a row for every number whose member `known` is finite; among figures, only the principal
/// figures get a row. A table without rows is not added.
template <class MakeCells>
void add_dependence_table(const Result& result, double NamedScalar::*known, FigureTable table,
                          const MakeCells& cells, std::vector<FigureTable>& tables) {
  for (const auto& scalar : result.scalars)
    if (std::isfinite(scalar.*known)) table.rows.push_back({scalar.name, cells(scalar)});
  for (const auto& figure : result.figures)
    if (const std::string name = principal_name(figure.name); std::isfinite(figure.*known) && !name.empty())
      table.rows.push_back({name, cells(figure)});
  if (!table.rows.empty()) tables.push_back(std::move(table));
}

void add_spread(const Result& result, std::vector<FigureTable>& tables) {
  add_dependence_table(
      result, &NamedScalar::least, {"over all equilibria", {"this one", "least", "largest", ""}, {}},
      [](const NamedScalar& s) {
        return Cells{fmt::format("{:.6g}", s.value), fmt::format("{:.6g}", s.least),
                     fmt::format("{:.6g}", s.largest), unit_text(s.unit)};
      },
      tables);
}

void add_swing(const Result& result, std::vector<FigureTable>& tables) {
  if (!result.swing) return;
  add_dependence_table(
      result, &NamedScalar::per_swing,
      {"per metre that " + result.swing->furthest + " moves", {"here", "changes by", ""}, {}},
      [](const NamedScalar& s) {
        return Cells{fmt::format("{:.6g}", s.value), fmt::format("{:.2g}", s.per_swing), unit_text(s.unit)};
      },
      tables);
}

/// The change of a figure in percent of its value; "-" if the change is not known or the value is zero.
std::string percent_text(const Result& result, const KeySensitivities::Row& row) {
  const NamedScalar* figure = find_scalar(result.scalars, row.figure);
  if (!figure) figure = find_scalar(result.figures, row.figure);
  return figure && figure->value != 0 ? fmt::format("{:+.2g} %", 100 * row.effect() / std::abs(figure->value))
                                      : "-";
}

void add_sensitivities(const Result& result, std::vector<FigureTable>& tables) {
  if (!result.sensitivities) return;
  FigureTable table{"depends most on", {}, {}, false, result.sensitivities->note};
  if (!result.sensitivities->rows.empty())
    table.headings = {"number", "value", "1 % more of it", "", "one unit more"};
  for (const auto& row : result.sensitivities->rows) {
    const std::string unit = unit_text(row.figure_unit), name = principal_name(row.figure);
    table.rows.push_back(
        {name.empty() ? row.figure : name,
         {row.path, text_with_unit(fmt::format("{:.4g}", row.value), row.unit),
          text_with_unit(fmt::format("{:+.3g}", row.effect()), unit), percent_text(result, row),
          text_with_unit(fmt::format("{:+.3g}", row.derivative), unit_of_ratio(unit, row.unit))}});
  }
  tables.push_back(std::move(table));
}

void add_forces(const Result& result, std::vector<FigureTable>& tables) {
  if (result.hold_forces.empty()) return;
  double largest = 0;
  for (const auto& h : result.hold_forces)
    for (const double f : h.force) largest = std::fmax(largest, std::abs(f));
  FigureTable table{"forces as modelled [N]", {"x", "y", "z"}, {}};
  const auto add = [&](const std::string& name, const std::array<double, 3>& force, const char* format) {
    Cells cells;
    for (const double f : force)
      cells.push_back(measured(std::abs(f) <= kTableRoundOff * largest ? 0 : f, 0, format));
    table.rows.push_back({name, cells});
  };
  for (const auto& f : result.part_forces)
    if (!result.gear && f.force != std::array<double, 3>{}) add(f.part + ", " + f.term, f.force, "{:.6g}");
  for (const auto& h : result.hold_forces) add(h.name + ", held", h.force, "{:.6g}");
  add("sum of all", result.balance, "{:.2g}");
  tables.push_back(std::move(table));
}

}  // namespace

std::vector<FigureTable> report_tables(const Result& result) {
  std::vector<FigureTable> tables;
  add_sensitivities(result, tables);
  add_spread(result, tables);
  add_swing(result, tables);
  add_gear_tables(result.figures, result.is_half(), tables);
  add_forces(result, tables);
  return tables;
}

}  // namespace netloft::results
