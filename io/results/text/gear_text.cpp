// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/gear_text.hpp"

#include "io/formats/units/degrees.hpp"
#include "io/results/figures/figure_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;

/// Adds the members of a group to `members`, each once and in the order of the figures. For example, the
/// group "ropes/" has the member "headrope" because of the figure "ropes/headrope/tension_end".
void add_members(const std::vector<NamedScalar>& figures, const std::string& group,
                 std::vector<std::string>& members) {
  for (const auto& figure : figures) {
    if (!figure.name.starts_with(group)) continue;
    std::string member = figure.name.substr(group.size());
    member = member.substr(0, member.find_last_of('/'));
    if (std::find(members.begin(), members.end(), member) == members.end()) members.push_back(member);
  }
}

/// A column of a table. The row of a member (a part, rope or body) shows the figure `before` + member +
/// `after`.
struct Column {
  std::string heading, before, after;
  const char* format = "{:.5g}";
  bool is_of_all = false;  // true: a figure in this column alone gives a member no row
  double factor = 1;       // factor from SI units to the unit of the heading
};

/// The text of a cell: the number in the unit of the heading, with its error if that is known.
std::string cell_of(const NamedScalar* scalar, const Column& column, double round_off) {
  if (!scalar || !std::isfinite(scalar->value)) return "-";
  const double value = std::abs(scalar->value) <= round_off ? 0 : scalar->value;
  return measured(column.factor * value, column.factor * total_error(*scalar), column.format);
}

/// Round-off of forces in a table: a small fraction of its largest force [N].
double round_off_of(const std::vector<NamedScalar>& figures, const std::vector<Column>& columns,
                    const std::vector<std::string>& members) {
  double largest = 0;
  for (const auto& member : members)
    for (const auto& c : columns)
      if (const auto* figure = find_scalar(figures, c.before + member + c.after);
          figure && figure->unit == "N")
        largest = std::fmax(largest, std::abs(figure->value));
  return kTableRoundOff * largest;
}

/// Adds a table with a row for every member that has figures for the columns; adds nothing if there is no
/// such member.
void add_table(const std::vector<NamedScalar>& figures, const std::string& title,
               const std::vector<Column>& columns, std::vector<FigureTable>& tables,
               bool is_for_deck = false) {
  std::vector<std::string> members;
  for (const auto& column : columns) add_members(figures, column.before, members);
  const double round_off = round_off_of(figures, columns, members);
  FigureTable table{title, {}, {}, is_for_deck};
  for (const auto& column : columns) table.headings.push_back(column.heading);
  for (const auto& member : members) {
    FigureTable::Row row{member, {}};
    bool is_known = false;
    for (const auto& c : columns) {
      const NamedScalar* figure = find_scalar(figures, c.before + member + c.after);
      is_known = is_known || (figure && !c.is_of_all);
      row.cells.push_back(cell_of(figure, c, figure && figure->unit == "N" ? round_off : 0));
    }
    if (is_known) table.rows.push_back(std::move(row));
  }
  if (!table.rows.empty()) tables.push_back(std::move(table));
}

/// Number of characters of a UTF-8 text.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string to_the_right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, letters(text)), ' ') + text;
}

void write(const FigureTable& table, Out out) {
  constexpr std::size_t kNarrow = 11;
  std::vector<std::size_t> widths;
  for (const auto& heading : table.headings) widths.push_back(std::max(kNarrow, letters(heading)));
  std::size_t name = std::max<std::size_t>(24, letters(table.title)) - 2;  // width of the first column
  for (const auto& row : table.rows) {
    name = std::max(name, letters(row.name));
    for (std::size_t i = 0; i < row.cells.size(); ++i) widths[i] = std::max(widths[i], letters(row.cells[i]));
  }
  const auto cells = [&](const std::vector<std::string>& texts) {
    for (std::size_t i = 0; i < texts.size(); ++i)
      fmt::format_to(out, " {}", to_the_right(texts[i], widths[i]));
    fmt::format_to(out, "\n");
  };
  fmt::format_to(out, "  {:<{}}", table.title, name + 2);
  cells(table.headings);
  for (const auto& row : table.rows) {
    fmt::format_to(out, "    {:<{}}", row.name, name);
    cells(row.cells);
  }
  if (!table.note.empty()) fmt::format_to(out, "    {}\n", table.note);
}

/// Adds a table of drag and weight, by kind of part or by part.
void force_table(const std::vector<NamedScalar>& figures, const std::string& title, const std::string& drag,
                 const std::string& weight, std::vector<FigureTable>& tables) {
  add_table(figures, title,
            {{"drag aft", drag, "/x"}, {"starboard", drag, "/y"}, {"up", drag, "/z"}, {"weight", weight, ""}},
            tables);
}

/// Adds the table of positions and attitudes of rigid bodies. Angles are positive outward and up.
void add_bodies(const std::vector<NamedScalar>& figures, std::vector<FigureTable>& tables) {
  const std::string body = "bodies/";
  add_table(figures, "bodies",
            {{"heading [°]", body, "/heading", "{:.2f}", false, formats::kDegreesPerRadian},
             {"heel [°]", body, "/heel", "{:.2f}", false, formats::kDegreesPerRadian},
             {"trim [°]", body, "/trim", "{:.2f}", false, formats::kDegreesPerRadian},
             {"x [m]", body, "/x"},
             {"y [m]", body, "/y"},
             {"z [m]", body, "/z"},
             {"above bed", body, "/above_bed", "{:.3f}"}},
            tables, true);
  add_table(figures, "water on bodies",
            {{"attack [°]", body, "/attack", "{:.2f}", false, formats::kDegreesPerRadian},
             {"sideslip [°]", body, "/sideslip", "{:.2f}", false, formats::kDegreesPerRadian},
             {"lift [N]", body, "/lift"},
             {"drag [N]", body, "/drag"},
             {"outward [N]", body, "/outward"}},
            tables, true);
  add_table(
      figures, "forces on bodies [N]",
      {{"aft", "body_forces/", "/x"}, {"outward", "body_forces/", "/out"}, {"up", "body_forces/", "/z"}},
      tables);
}

void add_warps(const std::vector<NamedScalar>& figures, std::vector<FigureTable>& tables) {
  add_table(figures, "warps",
            {{"length [m]", "warps/", "/length", "{:.6g}"},
             {"down [°]", "warps/", "/down_at_start", "{:.2f}", false, formats::kDegreesPerRadian},
             {"out [°]", "warps/", "/out_at_start", "{:.2f}", false, formats::kDegreesPerRadian},
             {"up, end [°]", "warps/", "/up_at_end", "{:.2f}", false, formats::kDegreesPerRadian}},
            tables, true);
  add_table(figures, "warps at the block",
            {{"tension [N]", "warps/", "/tension"}, {"out [m/s]", "warps/", "/paying_out", "{:.3f}"}},
            tables);
}

/// Adds the tables of tensions in ropes, and of the contact of the footrope.
void add_ropes(const std::vector<NamedScalar>& figures, bool is_half, std::vector<FigureTable>& tables) {
  const std::string rope = "ropes/", stretch = "footrope/";
  const Column largest{"largest [N]", rope, "/tension_largest", "{:.5g}", true},
      mass{"mass [kg]", rope, "/mass", "{:.5g}", true};
  const Column middle =
      is_half ? Column{"middle [N]", rope, "/tension_middle"} : Column{"port [N]", rope, "/tension_port"};
  add_table(figures, "ropes across the gear",
            {middle, {"starboard [N]", rope, "/tension_starboard"}, largest, mass}, tables);
  add_table(figures, "ropes",
            {{"start [N]", rope, "/tension_start"}, {"end [N]", rope, "/tension_end"}, largest, mass},
            tables);
  add_warps(figures, tables);
  add_table(figures, "footrope on the bed",
            {{"length [m]", stretch, "/touching", "{:.2f}"},
             {"force [N]", stretch, "/force", "{:.1f}"},
             {"[N/m]", stretch, "/force_per_metre", "{:.2f}"}},
            tables);
}

}  // namespace

NamedScalar in_spoken_unit(NamedScalar figure) {
  static constexpr struct {
    const char *unit, *spoken;
    double factor;
  } units[] = {
      {"1", "", 1}, {"m2", "m²", 1}, {"W", "kW", 1e-3}, {"kg/s", "kg/h", 3600}, {"kg/m2", "kg/ha", 1e4}};
  for (const auto& u : units)
    if (figure.unit == u.unit) {
      figure.unit = u.spoken;
      for (double* number : {&figure.value, &figure.solver_error, &figure.mesh_error}) *number *= u.factor;
      break;
    }
  return figure;
}

std::vector<PrincipalFigure> principal_figures(const std::vector<NamedScalar>& figures) {
  std::vector<PrincipalFigure> all;
  if (!are_of_plan(figures)) return all;
  double largest = 0;
  for (const auto& figure : figures)
    if (figure.unit == "N" && !principal_name(figure.name).empty())
      largest = std::fmax(largest, std::abs(figure.value));
  for (const auto& figure : figures) {
    const std::string name = principal_name(figure.name);
    if (name.empty()) continue;
    NamedScalar shown = in_spoken_unit(figure);
    if (figure.unit == "N" && std::abs(figure.value) <= kTableRoundOff * largest) shown.value = 0;
    all.push_back({name, measured(shown), shown.unit, figure.doc});
  }
  return all;
}

void add_gear_tables(const std::vector<NamedScalar>& figures, bool is_half,
                     std::vector<FigureTable>& tables) {
  add_bodies(figures, tables);
  if (!are_of_plan(figures)) return;
  add_ropes(figures, is_half, tables);
  add_table(figures, "power of towing", {{"[kW]", "power/", "", "{:.3f}", false, 1e-3}}, tables);
  const std::string panel = "panels/";
  std::vector<Column> netting = {{"open: least", panel, "/opening_min", "{:.3f}"},
                                 {"mean", panel, "/opening_mean", "{:.3f}"},
                                 {"most", panel, "/opening_max", "{:.3f}"},
                                 {"area [m²]", panel, "/area"},
                                 {"filtered", panel, "/filtered_area"},
                                 {"twine [m²]", panel, "/twine_area"},
                                 {"mass [kg]", panel, "/mass"}};
  if (find_scalar(figures, "mouth/water_speed"))
    netting.push_back({"water [m/s]", panel, "/water_speed", "{:.3f}"});
  add_table(figures, "netting", netting, tables);
  force_table(figures, "forces [N]", "drag/", "weight_in_water/", tables);
  force_table(figures, "forces by part [N]", "drag_by_part/", "weight_in_water_by_part/", tables);
}

FigureTable netting_table(const std::vector<scenes::NettingSheet>& netting) {
  FigureTable table{
      "netting to cut",
      {"number", "mesh [mm]", "twine", "laid", "fore", "aft", "deep", "outer side", "inner side"},
      {}};
  const auto meshes = [](double count) { return measured(count, 0, "{:.5g}"); };
  for (const auto& sheet : netting)
    table.rows.push_back({sheet.name,
                          {meshes(sheet.number), measured(1e3 * sheet.mesh, 0, "{:.4g}"),
                           sheet.twine + (sheet.twines > 1 ? " x " + meshes(sheet.twines) : ""), sheet.laid,
                           meshes(sheet.fore), meshes(sheet.aft),
                           meshes(sheet.deep) + (sheet.pieces > 1 ? " in " + meshes(sheet.pieces) : ""),
                           sheet.outer, sheet.inner.empty() ? "-" : sheet.inner}});
  return table;
}

std::string table_text(const FigureTable& table) {
  std::string text;
  write(table, std::back_inserter(text));
  return text;
}

}  // namespace netloft::results
