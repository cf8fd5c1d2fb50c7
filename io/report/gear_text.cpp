// SPDX-License-Identifier: BSD-3-Clause
#include "io/report/gear_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::io {

namespace {

using Out = std::back_insert_iterator<std::string>;

/// "12.3", or a dash for what is not known.
std::string number(const NamedScalar* scalar) {
  if (!scalar || !std::isfinite(scalar->value)) return "-";
  return fmt::format("{:.5g}", scalar->value);
}

std::string plus_minus(double error) {
  return std::isfinite(error) ? fmt::format("± {:<7.1e}", error) : "±  ?     ";
}

/// Names between `group` and the next slash, in the order of the figures, each once.
std::vector<std::string> members_of(const std::vector<NamedScalar>& figures, const std::string& group) {
  std::vector<std::string> members;
  for (const auto& figure : figures) {
    if (!figure.name.starts_with(group)) continue;
    const auto end = figure.name.find_last_of('/');
    const std::string member = end < group.size() ? figure.name.substr(group.size())
                                                  : figure.name.substr(group.size(), end - group.size());
    if (std::find(members.begin(), members.end(), member) == members.end()) members.push_back(member);
  }
  return members;
}

struct Column {
  const char *heading, *figure;
};

/// A line for every member of a group, a column for each of its figures.
void table(const std::vector<NamedScalar>& figures, const std::string& title, const std::string& group,
           const std::vector<Column>& columns, Out out) {
  const auto members = members_of(figures, group);
  if (members.empty()) return;
  fmt::format_to(out, "  {:<24}", title);
  for (const auto& column : columns) fmt::format_to(out, " {:>11}", column.heading);
  fmt::format_to(out, "\n");
  for (const auto& member : members) {
    fmt::format_to(out, "    {:<22}", member);
    for (const auto& column : columns)
      fmt::format_to(out, " {:>11}", number(find_scalar(figures, group + member + column.figure)));
    fmt::format_to(out, "\n");
  }
}

/// "headline_height" as it is spoken.
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Which errors are known of some figure.
struct Known {
  bool solver = false, mesh = false;
};

Known known_errors(const std::vector<NamedScalar>& figures) {
  Known known;
  for (const auto& f : figures)
    known.solver |= std::isfinite(f.solver_error), known.mesh |= std::isfinite(f.mesh_error);
  return known;
}

/// One figure a line, with its errors.
void list(const std::vector<NamedScalar>& figures, const std::string& group, const std::string& before,
          Out out) {
  const Known known = known_errors(figures);
  for (const auto& figure : figures)
    if (figure.name.starts_with(group))
      fmt::format_to(out, "  {:<24} {:>12.6g} {:<3}{} {}\n",
                     before + spoken(figure.name.substr(group.size())), figure.value,
                     figure.unit == "1"    ? ""
                     : figure.unit == "m2" ? "m²"
                                           : figure.unit,
                     known.solver ? errors_text(figure, known.mesh) : "", figure.doc);
}

}  // namespace

std::string errors_text(const NamedScalar& scalar, bool with_mesh) {
  std::string text = " " + plus_minus(scalar.solver_error);
  if (!with_mesh) return text;
  const std::string order =
      std::isfinite(scalar.mesh_order) ? fmt::format("(order {:.1f})", scalar.mesh_order) : "";
  return text + fmt::format(" {} {:<11}", plus_minus(scalar.mesh_error), order);
}

std::string gear_text(const std::vector<NamedScalar>& figures, bool is_half) {
  std::string text;
  if (figures.empty()) return text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "{}\n",
                 is_half ? "gear: a half was modelled; areas, masses, weights and forces aft and upwards are "
                           "those of the whole, both halves of it"
                         : "gear");
  list(figures, "mouth/", "", out);
  list(figures, "ground/", "ground ", out);
  list(figures, "drag/all/", "force of the water, ", out);
  table(figures, is_half ? "ropes (middle: start)" : "ropes", "ropes/",
        {{"start [N]", "/tension_start"},
         {"end [N]", "/tension_end"},
         {"largest [N]", "/tension_largest"},
         {"mass [kg]", "/mass"}},
        out);
  table(figures, "netting", "panels/",
        {{"open: least", "/opening_min"},
         {"mean", "/opening_mean"},
         {"most", "/opening_max"},
         {"area [m²]", "/area"},
         {"filtered", "/filtered_area"},
         {"twine [m²]", "/twine_area"},
         {"mass [kg]", "/mass"}},
        out);
  const std::vector<Column> axes = {{"aft", "/x"}, {"starboard", "/y"}, {"up", "/z"}};
  table(figures, "force of the water [N]", "drag/", axes, out);
  table(figures, "of that, by part [N]", "drag_by_part/", axes, out);
  table(figures, "weight in water [N]", "weight_in_water/", {{"", ""}}, out);
  table(figures, "of that, by part [N]", "weight_in_water_by_part/", {{"", ""}}, out);
  return text;
}

}  // namespace netloft::io
