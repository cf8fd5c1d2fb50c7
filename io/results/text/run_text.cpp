// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/run_text.hpp"

#include "framework/search/variants.hpp"

#include "io/results/text/gear_text.hpp"
#include "io/results/text/spread.hpp"
#include "io/results/text/swing.hpp"

#include <fmt/format.h>

#include <sstream>

#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;

void family_text(const FamilyPlan& family, Out out) {
  fmt::format_to(out, "{}: {} element{} in {} part{} ({} {})\n", family.type->type, family.elements,
                 family.elements == 1 ? "" : "s", family.parts.size(), family.parts.size() == 1 ? "" : "s",
                 family.type->origin->file.empty() ? "compiled in," : family.type->origin->file,
                 family.type->origin->version);
  if (family.viscosity_ratio != 1)
    fmt::format_to(out, "  they meet {:.4g} times the viscosity of the water\n", family.viscosity_ratio);
  for (const auto& term : family.terms)
    fmt::format_to(out, "  {:<12} {:<4} {}; {}\n", term.name, term.on ? "on" : "off", term.reason,
                   describe_traits(term.traits));
  for (const auto& g : family.globals)
    fmt::format_to(out, "  {:<12} an unknown that the elements of a part share: {} [{}]\n", g.name, g.doc,
                   g.unit);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// "coarse-to-fine, elements x 2"
std::string stage_name(const StageRecord& stage) {
  const std::string variant = text_of(stage.variant);
  return stage.name + (variant.empty() ? "" : ", " + variant);
}

const char* plural(int count) { return count == 1 ? "" : "s"; }

void shapes_text(const Shapes& shapes, Out out) {
  if (shapes.restarts == 0) return;
  fmt::format_to(out, "  {} restart{} for other shapes: {}; this one came up {} time{}\n", shapes.restarts,
                 plural(shapes.restarts),
                 shapes.others.empty() ? "none" : fmt::format("{} found", shapes.others.size()), shapes.times,
                 plural(shapes.times));
  for (const OtherShape& other : shapes.others)
    fmt::format_to(out,
                   "    another equilibrium is up to {:.3g} m away, at {}, with an energy of {:.10g} J "
                   "(found {} time{})\n",
                   other.distance, other.furthest, other.energy, other.times, plural(other.times));
  if (!shapes.others.empty())
    fmt::format_to(out, "  the answer is the one {}\n",
                   shapes.by_energy ? "of least energy"
                                    : "that was found first: forces without an energy do not say which the "
                                      "gear takes");
}

std::string ground_text(const ScenePlan& plan) {
  const auto& v = plan.ground;
  if (v == std::array<double, 3>{})
    return "stands; what lies on it sticks to where it was sketched until it slides";
  return fmt::format("passes the gear with ({:.4g}, {:.4g}) m/s; friction is that of sliding", v[0], v[1]);
}

void forces_text(const RunResult& result, bool is_of_plan, Out out) {
  if (!result.hold_forces.empty())
    fmt::format_to(out, "  {:<24} {:>14} {:>14} {:>14}\n",
                   is_of_plan ? "forces as modelled [N]" : "forces on the gear [N]", "x", "y", "z");
  for (const auto& f : result.part_forces)
    if (const bool is_in_gear_tables = f.is_drag() || f.is_weight(); !is_of_plan || !is_in_gear_tables)
      fmt::format_to(out, "  {:<24} {:>14.6g} {:>14.6g} {:>14.6g}\n", f.part + ", " + f.term, f.force[0],
                     f.force[1], f.force[2]);
  for (const auto& h : result.hold_forces)
    fmt::format_to(out, "  {:<24} {:>14.6g} {:>14.6g} {:>14.6g}\n", h.name + ", held", h.force[0], h.force[1],
                   h.force[2]);
  if (!result.hold_forces.empty())
    fmt::format_to(out, "  {:<24} {:>14.2g} {:>14.2g} {:>14.2g}\n", "sum of all", result.balance[0],
                   result.balance[1], result.balance[2]);
}

}  // namespace

std::string plan_text(const ScenePlan& plan, const PlanExtras& extras) {
  std::string text;
  const Out out = std::back_inserter(text);
  for (const auto& family : plan.families) family_text(family, out);
  if (!plan.not_loaded.empty())
    fmt::format_to(out, "not loaded: {} (no part uses them; a strategy loads those that it comes to)\n",
                   joined(plan.not_loaded));
  fmt::format_to(
      out, "problem: {} nodes, {} of them held, {}{} unknowns, {} matrix entries; {}{}\n", plan.nodes,
      plan.held_nodes,
      plan.bodies ? fmt::format("{} rigid bod{}, ", plan.bodies, plan.bodies > 1 ? "ies" : "y") : "",
      plan.unknowns, extras.matrix_entries,
      plan.symmetric ? "symmetric" : "unsymmetric because of " + plan.unsymmetric_because,
      plan.conservative ? ", every force has an energy" : "");
  if (plan.reads_ground()) fmt::format_to(out, "ground: {}\n", ground_text(plan));
  if (!extras.material_damping.empty())
    fmt::format_to(out, "material damping: {}\n", extras.material_damping);
  if (!extras.strategy.empty()) fmt::format_to(out, "strategy: {}, in this order\n", extras.strategy);
  for (const auto& line : lines_of(extras.attempts)) fmt::format_to(out, "  {}\n", line);
  fmt::format_to(out, "solver: {}\nfactorisation: {}\nthreads: {} given, {} used by the assembly\n",
                 extras.solver, extras.factorisation, extras.threads_given, extras.threads_used);
  return text;
}

std::string run_text(const scenes::LoadedScene& loaded, const ScenePlan& plan, const RunResult& result) {
  const Solution& s = result.solution;
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}", loaded.scene.name, name_of(s.status));
  if (s.stability != Stability::unknown) fmt::format_to(out, ", {} equilibrium", name_of(s.stability));
  fmt::format_to(out, "\n  {}\n", s.reason);
  for (const auto& sentence : s.diagnostics) fmt::format_to(out, "  {}\n", sentence);
  for (const auto& sentence : result.warnings) fmt::format_to(out, "  warning: {}\n", sentence);
  shapes_text(s.shapes, out);
  fmt::format_to(out, "  {} unknowns, {} iterations, {} factorisations, work {:.4g}, {:.3g} s\n",
                 plan.unknowns, s.cost.statistics.iterations, s.cost.statistics.factorisations, s.cost.work,
                 s.cost.statistics.total_seconds);
  if (s.cost.stages.size() > 1)
    for (const StageRecord& stage : s.cost.stages)
      fmt::format_to(out, "    {:<44} {:>7} unknowns {:>4} iterations {:>4} factorisations  {}\n",
                     stage_name(stage), stage.unknowns, stage.statistics.iterations,
                     stage.statistics.factorisations, name_of(stage.status));
  const bool with_errors = !result.mesh_note.empty();
  for (const auto& scalar : result.scalars)
    fmt::format_to(out, "  {:<24} {:>18.10g} {:<8}{} {}\n", scalar.name, scalar.value,
                   scalar.unit == "1" ? "" : scalar.unit, with_errors ? errors_text(scalar) : "", scalar.doc);
  if (with_errors)
    fmt::format_to(out, "  ± of the solver, ± of the mesh; the latter {}\n",
                   mesh_note_text(result.mesh_note));
  text += spread_text(result.scalars, result.gear);
  text += swing_text(result.swings_most, result.scalars, result.gear);
  forces_text(result, loaded.gear.has_value(), out);
  text += gear_text(result.gear, loaded.gear && loaded.gear->times == 2);
  if (!result.output_file.empty()) fmt::format_to(out, "  written to {}\n", result.output_file);
  return text;
}

}  // namespace netloft::results
