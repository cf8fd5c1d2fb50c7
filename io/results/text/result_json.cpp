// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/merged_scene.hpp"
#include "io/results/text/motion_text.hpp"
#include "io/results/text/result_text.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace netloft::results {

namespace {

using Json = nlohmann::ordered_json;

// Unknown numbers are written as null, because JSON has no NaN.

Json or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json values_json(const std::vector<NamedScalar>& scalars) {
  Json values = Json::object();
  for (const auto& s : scalars) values[s.name] = s.value;
  return values;
}

Json units_json(const std::vector<NamedScalar>& scalars) {
  Json units = Json::object();
  for (const auto& s : scalars) units[s.name] = s.unit;
  return units;
}

Json errors_json(const std::vector<NamedScalar>& scalars) {
  Json errors = Json::object();
  for (const auto& s : scalars)
    errors[s.name] = {{"solver", s.solver_error}, {"mesh", s.mesh_error}, {"mesh_order", s.mesh_order}};
  return errors;
}

/// The range of each number over all equilibria; null if only one equilibrium was found.
Json spread_json(const std::vector<NamedScalar>& scalars) {
  Json spread = nullptr;
  for (const auto& s : scalars)
    if (std::isfinite(s.least)) spread[s.name] = {{"least", s.least}, {"largest", s.largest}};
  return spread;
}

Json gear_json(const Result& result) {
  if (result.figures.empty()) return nullptr;
  return {{"modelled", result.is_half() ? "half" : "whole"}, {"times", result.is_half() ? 2 : 1},
          {"figures", values_json(result.figures)},          {"units", units_json(result.figures)},
          {"errors", errors_json(result.figures)},           {"spread", spread_json(result.figures)}};
}

Json swing_json(const Result& result) {
  if (!result.swing) return nullptr;
  Json per_metre = Json::object();
  for (const auto* scalars : {&result.scalars, &result.figures})
    for (const auto& s : *scalars)
      if (std::isfinite(s.per_swing)) per_metre[s.name] = s.per_swing;
  const auto time = [](double angle, double rate) { return rate > 0 ? Json(angle / rate) : Json(nullptr); };
  return {{"furthest", result.swing->furthest},
          {"tenfold_in", time(std::log(10), result.swing->rate)},
          {"period", time(2 * std::numbers::pi, result.swing->frequency)},
          {"share", result.swing->share},
          {"per_metre", per_metre}};
}

/// The largest sensitivities of the key figures; null if they were not requested.
Json sensitivities_json(const std::optional<KeySensitivities>& all) {
  if (!all) return nullptr;
  Json rows = Json::array();
  for (const auto& row : all->rows)
    rows.push_back({{"figure", row.figure},
                    {"path", row.path},
                    {"value", row.value},
                    {"unit", row.unit},
                    {"derivative", row.derivative},
                    {"effect", row.effect()},
                    {"effect_unit", row.figure_unit}});
  return {{"note", all->note}, {"rows", rows}};
}

Json seconds_json(const Result& r) {
  const Statistics& s = r.statistics;
  return {{"reading", r.reading_seconds},
          {"setup", r.setup_seconds},
          {"assembly", s.assembly_seconds},
          {"analysis", s.analysis_seconds},
          {"factorisation", s.factorisation_seconds},
          {"solve", s.solve_seconds},
          {"solver_total", s.total_seconds},
          {"total", r.reading_seconds + r.setup_seconds + s.total_seconds}};
}

/// All stages of the search for the equilibrium, on the scene itself and on easier variants.
Json stages_json(const std::vector<Stage>& all) {
  Json stages = Json::array();
  for (const Stage& stage : all)
    stages.push_back({{"name", stage.name},
                      {"variant",
                       {{"level", stage.variant.level},
                        {"stiffness_cap", stage.variant.stiffness_cap},
                        {"compression", stage.variant.compression},
                        {"current", stage.variant.current}}},
                      {"solver", stage.solver},
                      {"unknowns", stage.unknowns},
                      {"status", stage.outcome},
                      {"reason", stage.sentence},
                      {"iterations", stage.statistics.iterations},
                      {"factorisations", stage.statistics.factorisations},
                      {"work", stage.work},
                      {"seconds", stage.statistics.total_seconds}});
  return stages;
}

/// Other equilibria; null if there was no search for them.
Json shapes_json(const std::optional<FoundShapes>& shapes) {
  if (!shapes) return nullptr;
  Json others = Json::array();
  for (const auto& other : shapes->others)
    others.push_back({{"energy", other.energy},
                      {"distance", other.distance},
                      {"furthest", other.furthest},
                      {"times", other.times}});
  return {{"restarts", shapes->restarts},
          {"times", shapes->times},
          {"chosen_by", shapes->by_energy ? "least energy" : "found first"},
          {"others", others}};
}

/// The forces on parts; zero forces are left out.
Json part_forces_json(const std::vector<PartLoad>& all) {
  Json forces = Json::array();
  for (const auto& f : all)
    if (f.force != std::array<double, 3>{})
      forces.push_back({{"part", f.part}, {"term", f.term}, {"force", f.force}});
  return forces;
}

Json hold_forces_json(const std::vector<HoldForce>& all) {
  Json held = Json::array();
  for (const auto& h : all) held.push_back({{"name", h.name}, {"force", h.force}});
  return held;
}

Json materials_json(const std::vector<Material>& materials) {
  Json all = Json::array();
  for (const auto& m : materials)
    all.push_back({{"kind", m.item.kind},
                   {"name", m.item.name},
                   {"part", m.item.part_name},
                   {"number", m.item.number},
                   {"diameter", m.item.diameter},
                   {"length", m.length},
                   {"area", m.area},
                   {"mass", m.mass},
                   {"load", m.load},
                   {"breaking_load", m.item.breaking_load},
                   {"utilisation", m.utilisation()}});
  return all;
}

Json conditions_json(const Result& result) {
  Json all = Json::object();
  for (const auto& one : conditions_of(result)) all[one.name] = one.value;
  return all;
}

Json netting_json(const std::vector<scenes::NettingSheet>& netting) {
  Json all = Json::array();
  for (const auto& sheet : netting)
    all.push_back({{"name", sheet.name},
                   {"number", sheet.number},
                   {"mesh", sheet.mesh},
                   {"twine", sheet.twine},
                   {"twines", sheet.twines},
                   {"laid", sheet.laid},
                   {"fore", sheet.fore},
                   {"aft", sheet.aft},
                   {"deep", sheet.deep},
                   {"pieces", sheet.pieces},
                   {"outer", sheet.outer},
                   {"inner", sheet.inner}});
  return all;
}

/// How the result was found, and the cost of the solve.
Json solve_json(const Result& r) {
  const Statistics& s = r.statistics;
  return {{"solver", r.solver},
          {"strategy", r.strategy},
          {"factorisation", r.factorisation},
          {"iterations", s.iterations},
          {"residuals", s.residuals},
          {"factorisations", s.factorisations},
          {"wall_seconds", seconds_json(r)},
          {"cpu_seconds", s.total_cpu_seconds},
          {"judging_cpu_seconds", s.total_cpu_seconds - s.solver_cpu_seconds},
          {"work", r.work},
          {"stages", stages_json(r.stages)},
          {"residual", r.residual},
          {"largest_load", r.largest_load},
          {"energy", r.energy},
          {"plan", r.origins.plan}};
}

}  // namespace

std::string result_json(const Result& r) {
  Json json = {{"scene", r.title},
               {"output", or_null(r.path)},
               {"status", or_null(r.outcome)},
               {"stability", or_null(r.stability)},
               {"reason", r.sentence},
               {"diagnostics", r.diagnostics},
               {"warnings", r.warnings},
               {"notes", r.notes},
               {"version", r.origins.version},
               {"shapes", shapes_json(r.shapes)},
               {"at_fault", or_null(r.at_fault)},
               {"nodes", r.nodes},
               {"unknowns", r.unknowns},
               {"states", r.states},
               {"results", values_json(r.scalars)},
               {"units", units_json(r.scalars)},
               {"errors", errors_json(r.scalars)},
               {"spread", spread_json(r.scalars)},
               {"swing", swing_json(r)},
               {"sensitivities", sensitivities_json(r.sensitivities)},
               {"mesh_note", or_null(r.mesh_note)},
               {"node_error", r.node_error},
               {"gear", gear_json(r)},
               {"materials", materials_json(r.materials)},
               {"netting", netting_json(r.netting)},
               {"conditions", conditions_json(r)},
               {"part_forces", part_forces_json(r.part_forces)},
               {"hold_forces", hold_forces_json(r.hold_forces)},
               {"balance", r.balance}};
  json.update(solve_json(r));
  if (r.motion) json.update(motion_json(r));
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::results
