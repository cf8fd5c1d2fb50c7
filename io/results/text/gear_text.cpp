// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/gear_text.hpp"

#include "io/formats/units/degrees.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;

/// Formats a number, or "-" if it is unknown.
std::string number(const NamedScalar* scalar, const char* format, double factor) {
  if (!scalar || !std::isfinite(scalar->value)) return "-";
  std::string text = fmt::format(fmt::runtime(format), factor * scalar->value);
  if (text.find_first_of("123456789") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
  return text;
}

std::string plus_minus(double error) {
  return std::isfinite(error) ? fmt::format("± {:<7.1e}", error) : "±  ?     ";
}

/// Adds the name between `group` and the next slash to `members`, in the order of the figures, each name
/// once.
void add_members(const std::vector<NamedScalar>& figures, const std::string& group,
                 std::vector<std::string>& members) {
  for (const auto& figure : figures) {
    if (!figure.name.starts_with(group)) continue;
    std::string member = figure.name.substr(group.size());
    member = member.substr(0, member.find_last_of('/'));
    if (std::find(members.begin(), members.end(), member) == members.end()) members.push_back(member);
  }
}

/// Whether its error from other meshes is known and more than round-off.
bool depends_on_mesh(const NamedScalar& scalar) {
  constexpr double kRoundOff = 1e-9;  // of the number, which has five digits
  return std::isfinite(scalar.mesh_error) && scalar.mesh_error > kRoundOff * std::abs(scalar.value);
}

/// A column of a table with a row per member: it shows the figure `before` + member + `after`.
struct Column {
  std::string heading, before, after;
  const char* format = "{:.5g}";
  bool is_of_all = false;  // whoever has only such figures has no row
  double factor = 1;       // from SI units to those of the heading
};

/// The number, and how far it may be off on account of the mesh.
std::string with_error(const NamedScalar* scalar, const Column& column) {
  const std::string text = number(scalar, column.format, column.factor);
  return scalar && depends_on_mesh(*scalar)
             ? text + fmt::format(" ± {:.1e}", column.factor * total_error(*scalar))
             : text;
}

/// Makes a row for every member of the columns' groups; no table without rows.
void add_table(const std::vector<NamedScalar>& figures, const std::string& title,
               const std::vector<Column>& columns, std::vector<FigureTable>& tables) {
  std::vector<std::string> members;
  for (const auto& column : columns) add_members(figures, column.before, members);
  FigureTable table{title, {}, {}};
  for (const auto& column : columns) table.headings.push_back(column.heading);
  for (const auto& member : members) {
    FigureTable::Row row{member, {}};
    bool is_known = false;
    for (const auto& c : columns) {
      const NamedScalar* figure = find_scalar(figures, c.before + member + c.after);
      is_known = is_known || (figure && !c.is_of_all);
      row.cells.push_back(with_error(figure, c));
    }
    if (is_known) table.rows.push_back(std::move(row));
  }
  if (!table.rows.empty()) tables.push_back(std::move(table));
}

/// Letters, of which some take several bytes.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string to_the_right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, letters(text)), ' ') + text;
}

void write(const FigureTable& table, Out out) {
  constexpr std::size_t kNarrow = 11, kWide = 20;
  bool is_wide = false;
  for (const auto& row : table.rows)
    for (const auto& cell : row.cells) is_wide = is_wide || letters(cell) > kNarrow;
  const auto cells = [&](const std::vector<std::string>& texts) {
    for (const auto& text : texts) fmt::format_to(out, " {}", to_the_right(text, is_wide ? kWide : kNarrow));
    fmt::format_to(out, "\n");
  };
  fmt::format_to(out, "  {:<24}", table.title);
  cells(table.headings);
  for (const auto& row : table.rows) {
    fmt::format_to(out, "    {:<22}", row.name);
    cells(row.cells);
  }
}

/// The name of a figure in words: "headline height" for "headline_height", "door spread" for "door/spread".
std::string spoken(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '_' || c == '/'; }, ' ');
  return name;
}

/// A figure in the unit in which its trade speaks of it.
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

/// "pairs/door/spread" and what spreads it; the rest of a pair stands in the tables of its bodies.
bool is_of_pair(const std::string& name) {
  return name.starts_with("pairs/") &&
         (name.ends_with("/spread") || name.ends_with("/spread_force") || name.ends_with("/ground_share"));
}

/// Drag and weight of every kind, or of every part.
void force_table(const std::vector<NamedScalar>& figures, const std::string& title, const std::string& drag,
                 const std::string& weight, std::vector<FigureTable>& tables) {
  add_table(figures, title,
            {{"drag aft", drag, "/x"}, {"starboard", drag, "/y"}, {"up", drag, "/z"}, {"weight", weight, ""}},
            tables);
}

/// Where every rigid body is and how it is turned; angles are outward and up.
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
            tables);
  add_table(figures, "water on bodies",
            {{"attack [°]", body, "/attack", "{:.2f}", false, formats::kDegreesPerRadian},
             {"sideslip [°]", body, "/sideslip", "{:.2f}", false, formats::kDegreesPerRadian},
             {"lift [N]", body, "/lift"},
             {"drag [N]", body, "/drag"},
             {"outward [N]", body, "/outward"}},
            tables);
  add_table(
      figures, "forces on bodies [N]",
      {{"aft", "body_forces/", "/x"}, {"outward", "body_forces/", "/out"}, {"up", "body_forces/", "/z"}},
      tables);
}

void add_warps(const std::vector<NamedScalar>& figures, std::vector<FigureTable>& tables) {
  add_table(figures, "warps",
            {{"length [m]", "warps/", "/length", "{:.4f}"},
             {"down, start", "warps/", "/down_at_start", "{:.2f}°", false, formats::kDegreesPerRadian},
             {"out, start", "warps/", "/out_at_start", "{:.2f}°", false, formats::kDegreesPerRadian},
             {"up, end", "warps/", "/up_at_end", "{:.2f}°", false, formats::kDegreesPerRadian}},
            tables);
  add_table(figures, "warps at the block",
            {{"tension [N]", "warps/", "/tension"}, {"out [m/s]", "warps/", "/paying_out", "{:.3f}"}},
            tables);
}

/// What ropes pull with and where they lie.
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

bool are_of_plan(const std::vector<NamedScalar>& figures) {
  if (figures.empty()) return false;
  const std::string& last = figures.back().name;
  return !last.starts_with("bodies/") && !last.starts_with("body_forces/");
}

std::string principal_name(const std::string& figure) {
  const std::string last = spoken(figure.substr(figure.find('/') + 1));
  if (figure.starts_with("mouth/")) return last == "area" ? "mouth area" : last;
  if (figure == "drag/all/x") return "drag";
  if (figure.starts_with("netting/")) return "netting " + last;
  if (figure.starts_with("ground/")) return "ground " + last;
  if (figure.starts_with("rigging/")) return figure.substr(8, figure.rfind('/') - 8) + " pull";
  if (is_of_pair(figure)) return spoken(figure.substr(6));
  if (figure.starts_with("towing/")) return "towing " + last;
  if (figure == "weight_in_water/all") return "weight in water";
  if (figure.starts_with("budget/")) return "  " + last;
  return "";
}

double total_error(const NamedScalar& scalar) { return scalar.solver_error + scalar.mesh_error; }

std::string mesh_note_text(std::string note) {
  for (auto at = note.find('\n'); at != std::string::npos; at = note.find('\n', at + 1))
    note.insert(at + 1, 4, ' ');
  return note;
}

std::string error_text(const NamedScalar& scalar) {
  const double error = total_error(scalar);
  return std::isfinite(error) ? fmt::format("± {:.1e}", error) : "±?";
}

std::string errors_text(const NamedScalar& scalar) {
  std::string text = " " + plus_minus(scalar.solver_error);
  const std::string order =
      std::isfinite(scalar.mesh_order) ? fmt::format("(order {:.1f})", scalar.mesh_order) : "";
  return text + fmt::format(" {} {:<11}", plus_minus(scalar.mesh_error), order);
}

GearTables gear_tables(const std::vector<NamedScalar>& figures, bool is_half) {
  GearTables all;
  add_bodies(figures, all.bodies);
  if (!are_of_plan(figures)) return all;
  for (const auto& figure : figures)
    if (const std::string name = principal_name(figure.name); !name.empty())
      all.principal.push_back({name, in_spoken_unit(figure)});
  add_ropes(figures, is_half, all.gear);
  add_table(figures, "power of towing", {{"[kW]", "power/", "", "{:.3f}", false, 1e-3}}, all.gear);
  const std::string panel = "panels/";
  add_table(figures, "netting",
            {{"open: least", panel, "/opening_min", "{:.3f}"},
             {"mean", panel, "/opening_mean", "{:.3f}"},
             {"most", panel, "/opening_max", "{:.3f}"},
             {"area [m²]", panel, "/area"},
             {"filtered", panel, "/filtered_area"},
             {"twine [m²]", panel, "/twine_area"},
             {"mass [kg]", panel, "/mass"}},
            all.gear);
  force_table(figures, "forces [N]", "drag/", "weight_in_water/", all.gear);
  force_table(figures, "forces by part [N]", "drag_by_part/", "weight_in_water_by_part/", all.gear);
  return all;
}

std::string gear_text(const std::vector<NamedScalar>& figures, bool is_half) {
  std::string text;
  const Out out = std::back_inserter(text);
  const GearTables all = gear_tables(figures, is_half);
  for (const auto& table : all.bodies) write(table, out);
  if (all.gear.empty() && all.principal.empty()) return text;
  fmt::format_to(out, "gear{}\n", is_half ? std::string(": ") + kOfHalf : "");
  for (const auto& [name, figure] : all.principal)
    fmt::format_to(out, "  {:<24} {:>12.6g} {:<5} {:<9} {}\n", name, figure.value, figure.unit,
                   error_text(figure), figure.doc);
  for (const auto& table : all.gear) write(table, out);
  return text;
}

}  // namespace netloft::results
