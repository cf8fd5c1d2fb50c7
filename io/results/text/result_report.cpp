// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/result_report.hpp"

#include "io/results/file/materials.hpp"
#include "io/results/text/gear_text.hpp"
#include "io/results/text/spread.hpp"
#include "io/results/text/swing.hpp"
#include "io/results/text/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;
using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string cell(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

void head_text(const StoredResult& result, Out out) {
  fmt::format_to(out, "{}: {}", result.title(),
                 result.outcome.empty() ? "the run has not ended" : result.outcome);
  if (!result.stability.empty() && result.stability != "unknown")
    fmt::format_to(out, ", {} equilibrium", result.stability);
  fmt::format_to(out, "\n");
  if (!result.sentence.empty()) fmt::format_to(out, "  {}\n", result.sentence);
  fmt::format_to(out, "  {} nodes, {} elements, {} state{}", result.mesh.n_points, result.mesh.n_cells,
                 result.times.size(), result.times.size() == 1 ? "" : "s");
  const auto iterations = result.cost.find("iterations"), seconds = result.cost.find("total");
  if (iterations != result.cost.end()) fmt::format_to(out, ", {:.0f} iterations", iterations->second.value);
  if (seconds != result.cost.end()) fmt::format_to(out, ", {:.3g} s", seconds->second.value);
  fmt::format_to(out, "\n");
  for (const auto& note : result.notes) fmt::format_to(out, "  {}\n", note);
}

void scalars_text(const StoredResult& result, Out out) {
  for (const auto& s : result.scalars)
    fmt::format_to(out, "  {:<24} {:>18.10g} {:<8} {} {}\n", s.name, s.value, s.unit == "1" ? "" : s.unit,
                   error_text(s), s.doc);
}

void forces_text(const StoredResult& result, Out out) {
  if (result.hold_forces.empty()) return;
  const auto row = [&](const std::string& name, const std::array<double, 3>& force) {
    fmt::format_to(out, "  {:<24} {:>14.6g} {:>14.6g} {:>14.6g}\n", name, force[0], force[1], force[2]);
  };
  fmt::format_to(out, "  {:<24} {:>14} {:>14} {:>14}\n", "forces as modelled [N]", "x", "y", "z");
  if (!are_of_plan(result.figures))
    for (const auto& f : result.part_forces)
      if (f.force[0] != 0 || f.force[1] != 0 || f.force[2] != 0) row(f.part + ", " + f.term, f.force);
  for (const auto& h : result.hold_forces) row(h.name + ", held", h.force);
  row("sum of all", result.balance);
}

void materials_text(const std::vector<Material>& materials, Out out) {
  if (materials.empty()) return;
  fmt::format_to(out, "  {:<24} {:<26} {:>6} {:>11} {:>11} {:>11} {:>11} {:>6}\n", "materials", "part",
                 "number", "length [m]", "mass [kg]", "load [N]", "breaks at", "");
  for (const auto& m : materials)
    fmt::format_to(out, "    {:<22} {:<26} {:>6} {:>11} {:>11} {:>11} {:>11} {:>6}\n", m.item.name,
                   m.item.part_name, cell(m.item.number, "{:g}"), cell(m.length, "{:.5g}"),
                   cell(m.mass, "{:.5g}"), cell(m.load, "{:.5g}"), cell(m.item.breaking_load, "{:.6g}"),
                   cell(100 * m.utilisation(), "{:.0f} %"));
  for (const auto& warning : load_warnings(materials)) fmt::format_to(out, "  warning: {}\n", warning);
}

Json figures_json(const std::vector<NamedScalar>& figures) {
  Json all = Json::object();
  for (const auto& f : figures)
    all[f.name] = {{"value", number(f.value)},
                   {"unit", f.unit},
                   {"error", number(total_error(f))},
                   {"solver_error", number(f.solver_error)},
                   {"mesh_error", number(f.mesh_error)},
                   {"least", number(f.least)},
                   {"largest", number(f.largest)},
                   {"per_swing", number(f.per_swing)},
                   {"doc", f.doc}};
  return all;
}

Json materials_json(const std::vector<Material>& materials) {
  Json all = Json::array();
  for (const auto& m : materials)
    all.push_back({{"kind", m.item.kind},
                   {"name", m.item.name},
                   {"part", m.item.part_name},
                   {"number", number(m.item.number)},
                   {"diameter", number(m.item.diameter)},
                   {"length", number(m.length)},
                   {"area", number(m.area)},
                   {"mass", number(m.mass)},
                   {"load", number(m.load)},
                   {"breaking_load", number(m.item.breaking_load)},
                   {"utilisation", number(m.utilisation())}});
  return all;
}

}  // namespace

std::string result_text(const StoredResult& result) {
  std::string text;
  const Out out = std::back_inserter(text);
  head_text(result, out);
  scalars_text(result, out);
  text += spread_text(result.scalars, result.figures);
  text += swing_text(result.swings_most, result.scalars, result.figures);
  forces_text(result, out);
  text += gear_text(result.figures, result.is_half);
  materials_text(materials_of(result), out);
  if (!result.mesh_note.empty())
    fmt::format_to(out, "  ± of solver and mesh; the latter {}\n", mesh_note_text(result.mesh_note));
  fmt::format_to(out, "  read from {}, written by netloft {}\n", result.path.string(),
                 result.origins.version.empty() ? "of an unknown version" : result.origins.version);
  return text;
}

std::string result_json(const StoredResult& result) {
  Json held = Json::array();
  for (const auto& h : result.hold_forces) held.push_back({{"name", h.name}, {"force", h.force}});
  const auto materials = materials_of(result);
  const Json json = {{"scene", result.title()},
                     {"file", result.path.string()},
                     {"status", result.outcome.empty() ? Json(nullptr) : Json(result.outcome)},
                     {"reason", result.sentence},
                     {"stability", result.stability},
                     {"swings_most", result.swings_most.empty() ? Json(nullptr) : Json(result.swings_most)},
                     {"version", result.origins.version},
                     {"nodes", result.mesh.n_points},
                     {"elements", result.mesh.n_cells},
                     {"states", result.times.size()},
                     {"notes", result.notes},
                     {"results", figures_json(result.scalars)},
                     {"gear", figures_json(result.figures)},
                     {"hold_forces", held},
                     {"materials", materials_json(materials)},
                     {"warnings", load_warnings(materials)},
                     {"mesh_note", result.mesh_note.empty() ? Json(nullptr) : Json(result.mesh_note)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string result_csv(const StoredResult& result) {
  std::string text = "name,value,unit,solver_error,mesh_error,doc\n";
  for (const auto* group : {&result.scalars, &result.figures})
    for (const auto& f : *group)
      text += fmt::format("{},{},{},{},{},{}\n", csv_field(f.name), csv_number(f.value), csv_field(f.unit),
                          csv_number(f.solver_error), csv_number(f.mesh_error), csv_field(f.doc));
  for (const auto& h : result.hold_forces)
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += fmt::format("{},{},N,,,force of the hold on the gear\n",
                          csv_field("held/" + h.name + "/" + "xyz"[axis]), csv_number(h.force[axis]));
  return text;
}

}  // namespace netloft::results
