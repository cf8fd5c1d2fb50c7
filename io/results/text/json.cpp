// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/gear_json.hpp"
#include "io/results/text/run_text.hpp"
#include "io/results/text/spread.hpp"
#include "io/results/text/swing.hpp"

namespace netloft::results {

namespace {

using Json = nlohmann::ordered_json;

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

Json seconds_json(const RunResult& r) {
  const Statistics& b = r.solution.cost.statistics;
  return {{"reading", r.reading_seconds},
          {"setup", r.setup_seconds},
          {"assembly", b.assembly_seconds},
          {"analysis", b.analysis_seconds},
          {"factorisation", b.factorisation_seconds},
          {"solve", b.solve_seconds},
          {"solver_total", b.total_seconds},
          {"total", r.reading_seconds + r.setup_seconds + b.total_seconds}};
}

/// Every stage of the search, those on easier variants included.
Json stages_json(const Solution& s) {
  Json stages = Json::array();
  for (const StageRecord& stage : s.cost.stages)
    stages.push_back({{"name", stage.name},
                      {"variant",
                       {{"level", stage.variant.level},
                        {"stiffness_cap", stage.variant.stiffness_cap},
                        {"compression", stage.variant.compression},
                        {"current", stage.variant.current}}},
                      {"solver", stage.solver},
                      {"unknowns", stage.unknowns},
                      {"status", name_of(stage.status)},
                      {"reason", stage.reason},
                      {"iterations", stage.statistics.iterations},
                      {"factorisations", stage.statistics.factorisations},
                      {"work", stage.work},
                      {"seconds", stage.statistics.total_seconds}});
  return stages;
}

/// Null where nobody looked for other shapes.
Json shapes_json(const Shapes& shapes) {
  if (shapes.restarts == 0) return nullptr;
  Json others = Json::array();
  for (const OtherShape& other : shapes.others)
    others.push_back({{"energy", other.energy},
                      {"distance", other.distance},
                      {"furthest", other.furthest},
                      {"times", other.times}});
  return {{"restarts", shapes.restarts},
          {"times", shapes.times},
          {"chosen_by", shapes.by_energy ? "least energy" : "found first"},
          {"others", others}};
}

/// What is asked of laws within and beyond the ranges that they were measured in.
Json laws_json(const Scene& scene, const std::vector<LawUse>& uses) {
  Json rows = Json::array();
  for (const LawUse& use : uses) {
    Json parts = Json::array();
    for (const auto part : use.parts) parts.push_back(scene.parts[part].name);
    for (const RangeUse& range : use.ranges)
      rows.push_back({{"law", use.law->type},
                      {"parts", parts},
                      {"quantity", name_of_quantity(range.range->quantity)},
                      {"range", {range.range->lo, range.range->hi}},
                      {"source", range.range->source},
                      {"fraction_outside", range.fraction_outside()},
                      {"seen", {range.least, range.most}}});
  }
  return rows;
}

Json part_forces_json(const RunResult& r) {
  Json forces = Json::array();
  for (const auto& f : r.part_forces)
    forces.push_back({{"part", f.part}, {"term", f.term}, {"force", f.force}});
  return forces;
}

Json hold_forces_json(const RunResult& r) {
  Json held = Json::array();
  for (const auto& h : r.hold_forces) held.push_back({{"name", h.name}, {"force", h.force}});
  return held;
}

/// One indented JSON text. Invalid bytes of a file name are replaced, so that the output is always valid
/// JSON.
std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

/// What the host's last checks took.
double judging_seconds(const Statistics& s) { return s.total_cpu_seconds - s.solver_cpu_seconds; }

}  // namespace

std::string plan_json(const Scene& scene, const ScenePlan& plan, const PlanExtras& extras) {
  return dump({{"scene", scene.name},
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
               {"threads", {{"given", extras.threads_given}, {"used", extras.threads_used}}}});
}

std::string run_json(const scenes::LoadedScene& loaded, const ScenePlan& plan, const RunResult& r) {
  const Solution& s = r.solution;
  return dump({{"scene", loaded.scene.name},
               {"status", name_of(s.status)},
               {"stability", name_of(s.stability)},
               {"reason", s.reason},
               {"diagnostics", s.diagnostics},
               {"warnings", r.warnings},
               {"laws", laws_json(loaded.scene, r.law_use)},
               {"shapes", shapes_json(s.shapes)},
               {"at_fault", s.status == SolveStatus::converged ? Json(nullptr) : Json(s.at_fault)},
               {"iterations", s.cost.statistics.iterations},
               {"factorisations", s.cost.statistics.factorisations},
               {"residual", s.balance.residual},
               {"largest_load", s.balance.scale},
               {"energy", s.energy},
               {"wall_seconds", seconds_json(r)},
               {"cpu_seconds", s.cost.statistics.total_cpu_seconds},
               {"judging_cpu_seconds", judging_seconds(s.cost.statistics)},
               {"unknowns", plan.unknowns},
               {"solver", loaded.analysis.solver},
               {"strategy", loaded.analysis.strategy},
               {"stages", stages_json(s)},
               {"work", s.cost.work},
               {"factorisation", s.run.factorisation},
               {"terms", terms_json(loaded.scene, plan)},
               {"results", values_json(r.scalars)},
               {"units", units_json(r.scalars)},
               {"errors", errors_json(r.scalars)},
               {"spread", spread_json(r.scalars)},
               {"swing", swing_json(r)},
               {"mesh_note", r.mesh_note.empty() ? Json(nullptr) : Json(r.mesh_note)},
               {"node_error", s.correction.length},
               {"gear", gear_json(loaded, r.gear)},
               {"part_forces", part_forces_json(r)},
               {"hold_forces", hold_forces_json(r)},
               {"balance", {{"force", r.balance}, {"largest_force", r.largest_force}}},
               {"output", r.output_file.empty() ? Json(nullptr) : Json(r.output_file)}});
}

}  // namespace netloft::results
