// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/result_text.hpp"

#include "framework/search/variants.hpp"
#include "io/results/figures/merged_scene.hpp"
#include "io/results/text/motion_text.hpp"
#include "io/results/text/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;

const char* plural(std::int64_t count) { return count == 1 ? "" : "s"; }

void shapes_text(const FoundShapes& shapes, Out out) {
  fmt::format_to(out, "  {} restart{} for other shapes: {}; the answer was found {} time{}\n",
                 shapes.restarts, plural(shapes.restarts),
                 shapes.others.empty() ? "none" : fmt::format("{} found", shapes.others.size()), shapes.times,
                 plural(shapes.times));
  for (const auto& other : shapes.others)
    fmt::format_to(out,
                   "    another equilibrium is up to {:.3g} m away, at {}, with an energy of {:.10g} J "
                   "(found {} time{})\n",
                   other.distance, other.furthest, other.energy, other.times, plural(other.times));
  if (!shapes.others.empty())
    fmt::format_to(
        out, "  the answer is the one {}\n",
        shapes.by_energy
            ? "of least energy"
            : "that was found first: forces without an energy do not show which equilibrium the gear takes");
}

void head_text(const Result& result, Out out) {
  fmt::format_to(out, "{}: {}\n", result.title, ending_text(result));
  if (!result.sentence.empty()) fmt::format_to(out, "  {}\n", result.sentence);
  const auto conditions = conditions_of(result);
  if (const std::string line = conditions_line(conditions); !line.empty())
    fmt::format_to(out, "  at {}\n", line);
  for (const auto* sentences : {&result.diagnostics, &result.notes})
    for (const auto& sentence : *sentences) fmt::format_to(out, "  {}\n", sentence);
  for (const auto& warning : result.warnings) fmt::format_to(out, "  warning: {}\n", warning);
  if (result.shapes) shapes_text(*result.shapes, out);
}

void scalars_text(const Result& result, Out out) {
  for (const auto& s : result.scalars)
    fmt::format_to(out, "  {:<24} {:>18} {:<8} {}{}\n", s.name, measured(s, "{:.10g}"), unit_text(s.unit),
                   std::isfinite(s.mesh_order) ? fmt::format("(order {:.1f}) ", s.mesh_order) : "", s.doc);
}

void principal_text(const Result& result, Out out) {
  const auto principal = principal_figures(result.figures);
  if (!principal.empty())
    fmt::format_to(out, "gear{}\n", result.is_half() ? std::string(": ") + kOfHalf : "");
  for (const auto& figure : principal)
    fmt::format_to(out, "  {:<24} {:>14} {:<5} {}\n", figure.name, figure.value, figure.unit, figure.doc);
}

void materials_text(const std::vector<Material>& materials, Out out) {
  if (materials.empty()) return;
  const auto cell = [](double value, const char* format) { return measured(value, 0, format); };
  fmt::format_to(out, "  {:<24} {:<26} {:>6} {:>11} {:>11} {:>11} {:>11} {:>6}\n", "materials", "part",
                 "number", "length [m]", "mass [kg]", "load [N]", "breaks at", "used");
  for (const auto& m : materials)
    fmt::format_to(out, "    {:<22} {:<26} {:>6} {:>11} {:>11} {:>11} {:>11} {:>6}\n", m.item.name,
                   m.item.part_name, cell(m.item.number, "{:g}"), cell(m.length, "{:.5g}"),
                   cell(m.mass, "{:.5g}"), cell(m.load, "{:.5g}"), cell(m.item.breaking_load, "{:.6g}"),
                   cell(100 * m.utilisation(), "{:.0f} %"));
}

/// The name of a stage with its variant: "coarse-to-fine, elements x 2".
std::string stage_name(const Stage& stage) {
  const std::string variant = text_of(stage.variant);
  return stage.name + (variant.empty() ? "" : ", " + variant);
}

void solve_text(const Result& result, Out out) {
  const Statistics& s = result.statistics;
  fmt::format_to(out, "  {} nodes, {} unknowns, {} state{}", result.nodes, result.unknowns, result.states,
                 plural(static_cast<std::int64_t>(result.states)));
  if (s.total_seconds > 0)
    fmt::format_to(out, ", {} iterations, {} factorisations, {:.3g} s", s.iterations, s.factorisations,
                   s.total_seconds);
  if (result.work > 0) fmt::format_to(out, ", work {:.4g}", result.work);
  fmt::format_to(out, "\n");
  if (result.stages.size() > 1)
    for (const Stage& stage : result.stages)
      fmt::format_to(out, "    {:<44} {:>7} unknowns {:>4} iterations {:>4} factorisations  {}\n",
                     stage_name(stage), stage.unknowns, stage.statistics.iterations,
                     stage.statistics.factorisations, stage.outcome);
}

/// Indents each line of a note after the first.
std::string indented(std::string note) {
  for (auto at = note.find('\n'); at != std::string::npos; at = note.find('\n', at + 1))
    note.insert(at + 1, 4, ' ');
  return note;
}

}  // namespace

std::string ending_text(const Result& result) {
  if (result.outcome.empty()) return "the run has not ended";
  if (result.stability.empty() || result.stability == "unknown") return result.outcome;
  if (result.outcome != "unstable") return result.outcome + ", " + result.stability + " equilibrium";
  return "unstable equilibrium" + (result.stability == "unstable" ? "" : ", " + result.stability);
}

std::string short_errors_text(const Result& result) {
  if (result.scalars.empty() && result.figures.empty()) return "";
  if (result.motion) return "errors of these numbers are not known";
  if (result.mesh_note.empty()) return "errors of the mesh are not known: run --error finds them";
  return "± is the error of solver and mesh together";
}

std::string errors_text(const Result& result) {
  const std::string text = short_errors_text(result);
  const bool has_meshes = !text.empty() && !result.motion && !result.mesh_note.empty();
  return has_meshes ? text + "; that of the mesh " + result.mesh_note : text;
}

std::string result_text(const Result& result) {
  std::string text;
  const Out out = std::back_inserter(text);
  head_text(result, out);
  scalars_text(result, out);
  principal_text(result, out);
  if (const std::string errors = errors_text(result); !errors.empty())
    fmt::format_to(out, "  {}\n", indented(errors));
  for (const auto& table : report_tables(result)) text += table_text(table);
  if (const auto netting = netting_table(result.netting); !netting.rows.empty()) text += table_text(netting);
  materials_text(result.materials, out);
  solve_text(result, out);
  if (result.motion) text += motion_text(result);
  fmt::format_to(out, "  written to {} by netloft {}\n", result.path,
                 result.origins.version.empty() ? "of an unknown version" : result.origins.version);
  return text;
}

}  // namespace netloft::results
