// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/plan_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>
#include <sstream>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;
using Json = nlohmann::ordered_json;

void family_text(const FamilyPlan& family, Out out) {
  fmt::format_to(out, "{}: {} element{} in {} part{} ({} {})\n", family.type->type, family.elements,
                 family.elements == 1 ? "" : "s", family.parts.size(), family.parts.size() == 1 ? "" : "s",
                 family.type->origin->file.empty() ? "compiled in," : family.type->origin->file,
                 family.type->origin->version);
  if (family.viscosity_ratio != 1)
    fmt::format_to(out,
                   "  the viscosity of the water is multiplied by {:.4g} for these elements, because of "
                   "[water] model_scale\n",
                   family.viscosity_ratio);
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

std::string ground_text(const ScenePlan& plan) {
  const auto& v = plan.ground;
  if (v == std::array<double, 3>{})
    return "is at rest; parts on it stick to their initial places until the friction is too small to hold "
           "them";
  return fmt::format("passes the gear with ({:.4g}, {:.4g}) m/s; its friction is that of sliding", v[0],
                     v[1]);
}

Json family_json(const Scene& scene, const FamilyPlan& family) {
  Json parts = Json::array(), terms = Json::array(), globals = Json::array();
  for (const auto part : family.parts) parts.push_back(scene.parts[part].name);
  for (const auto& t : family.terms)
    terms.push_back({{"name", t.name},
                     {"on", t.on},
                     {"reason", t.reason},
                     {"traits", describe_traits(t.traits)},
                     {"doc", t.doc}});
  for (const auto& g : family.globals)
    globals.push_back(
        {{"part", scene.parts[g.part].name}, {"name", g.name}, {"unit", g.unit}, {"doc", g.doc}});
  return {{"type", family.type->type},
          {"elements", family.elements},
          {"parts", parts},
          {"plugin", family.type->origin->file},
          {"version", family.type->origin->version},
          {"terms", terms},
          {"globals", globals}};
}

Json terms_json(const Scene& scene, const ScenePlan& plan) {
  Json families = Json::array();
  for (const auto& family : plan.families) families.push_back(family_json(scene, family));
  return families;
}

}  // namespace

std::string plan_text(const ScenePlan& plan, const PlanExtras& extras) {
  std::string text;
  const Out out = std::back_inserter(text);
  for (const auto& family : plan.families) family_text(family, out);
  if (!plan.not_loaded.empty())
    fmt::format_to(out, "not loaded: {} (no part uses them; a strategy loads those that it calls)\n",
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

std::string plan_json(const Scene& scene, const ScenePlan& plan, const PlanExtras& extras) {
  const Json json = {{"scene", scene.name},
                     {"families", terms_json(scene, plan)},
                     {"not_loaded", plan.not_loaded},
                     {"nodes", plan.nodes},
                     {"held_nodes", plan.held_nodes},
                     {"unknowns", plan.unknowns},
                     {"matrix_entries", extras.matrix_entries},
                     {"symmetric", plan.symmetric},
                     {"unsymmetric_because", plan.unsymmetric_because},
                     {"conservative", plan.conservative},
                     {"solver", extras.solver},
                     {"strategy", extras.strategy},
                     {"material_damping", extras.material_damping},
                     {"attempts", extras.attempts},
                     {"factorisation", extras.factorisation},
                     {"memory",
                      {{"foreseen", extras.memory},
                       {"factor", extras.factor_memory},
                       {"stability", extras.stability_memory}}},
                     {"threads", {{"given", extras.threads_given}, {"used", extras.threads_used}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::results
