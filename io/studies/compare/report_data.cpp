// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/csv.hpp"
#include "io/studies/compare/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;

using formats::csv_field, formats::csv_number;

std::string status_of(const Trial& t) { return t.outcome(); }

std::string trial_csv(const Comparison& c, const MethodResult& m, const Trial& t) {
  return fmt::format(
      "{},{},{},,{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", c.is_of_motions ? "motion" : "solver",
      csv_field(m.method.specification), t.tolerance, c.unknowns, status_of(t), csv_number(t.error),
      csv_number(t.estimate), t.tried ? csv_number(t.cpu_seconds) : "",
      t.tried && c.factorisation_seconds > 0 ? csv_number(t.cpu_seconds / c.factorisation_seconds) : "",
      t.statistics.iterations, t.statistics.factorisations, t.statistics.residuals, t.statistics.solves,
      m.reference ? csv_field(m.reference->method.specification) : "", m.other ? "yes" : "no",
      c.is_of_motions ? std::to_string(t.steps) : "", c.is_of_motions ? std::to_string(t.rejected) : "");
}

std::string mesh_csv(const MeshResult& level) {
  const Trial& t = level.trial;
  return fmt::format("discretisation,,{},{},{},{},{},{},{},,{},{},{},{},,,,\n", t.tolerance, level.cells,
                     level.unknowns, status_of(t), csv_number(level.error), csv_number(t.estimate),
                     csv_number(t.cpu_seconds), t.statistics.iterations, t.statistics.factorisations,
                     t.statistics.residuals, t.statistics.solves);
}

Json trial_json(const Comparison& c, const Trial& t) {
  if (!t.tried) return {{"tolerance", t.tolerance}, {"status", "not tried"}, {"reason", t.reason}};
  return {{"tolerance", t.tolerance},
          {"status", status_of(t)},
          {"stability", name_of(t.stability)},
          {"reason", t.reason},
          {"error", t.error},
          {"estimate", t.estimate},
          {"cpu_seconds", t.cpu_seconds},
          {"in_factorisations", t.cpu_seconds / c.factorisation_seconds},
          {"iterations", t.statistics.iterations},
          {"factorisations", t.statistics.factorisations},
          {"residuals", t.statistics.residuals},
          {"solves", t.statistics.solves},
          {"residual", t.residual},
          {"largest_load", t.load},
          {"energy", t.energy}};
}

Json motion_trial_json(const Trial& t) {
  return {{"accuracy", t.tolerance},
          {"status", status_of(t)},
          {"reason", t.reason},
          {"error", t.error},
          {"cpu_seconds", t.cpu_seconds},
          {"steps", t.steps},
          {"rejected_steps", t.rejected},
          {"iterations", t.statistics.iterations},
          {"factorisations", t.statistics.factorisations},
          {"residuals", t.statistics.residuals},
          {"solves", t.statistics.solves}};
}

Json path_reference_json(const std::optional<ReferenceAnswer>& r) {
  if (!r) return nullptr;
  return {{"integrator", r->method.name()},
          {"independent", r->independent},
          {"accuracy", r->tolerance},
          {"material_damping", r->is_damped},
          {"distance_of_another", r->answer.uncertainty}};
}

Json motion_json(const MethodResult& m) {
  Json trials = Json::array();
  for (const Trial& t : m.trials) trials.push_back(motion_trial_json(t));
  return {
      {"integrator", m.method.name()}, {"trials", trials}, {"reference", path_reference_json(m.reference)}};
}

/// The comparison of motions as JSON.
Json motions_json(const Comparison& c, const char* status) {
  Json methods = Json::array();
  for (const auto& m : c.methods) methods.push_back(motion_json(m));
  return {{"status", status},     {"scene", c.scene}, {"mesh", c.mesh},        {"unknowns", c.unknowns},
          {"repeats", c.repeats}, {"size", c.size},   {"integrators", methods}};
}

Json reference_json(const std::optional<ReferenceAnswer>& r) {
  if (!r) return nullptr;
  return {{"method", r->method.specification},
          {"independent", r->independent},
          {"tolerance", r->tolerance},
          {"stability", name_of(r->stability)},
          {"residual", r->answer.residual},
          {"largest_load", r->answer.load},
          {"uncertainty", r->answer.uncertainty},
          {"energy", r->answer.energy}};
}

Json other_json(const std::optional<OtherEquilibrium>& other) {
  if (!other) return nullptr;
  return {{"distance", other->distance},
          {"energy_difference", other->has_energy ? Json(other->energy_difference) : Json(nullptr)}};
}

Json method_json(const Comparison& c, const MethodResult& m) {
  Json trials = Json::array();
  for (const Trial& t : m.trials) trials.push_back(trial_json(c, t));
  return {{"method", m.method.specification},
          {"trials", trials},
          {"reference", reference_json(m.reference)},
          {"other_equilibrium", other_json(m.other)}};
}

Json discretisation_json(const std::optional<Discretisation>& d) {
  if (!d) return nullptr;
  Json levels = Json::array();
  for (const auto& level : d->levels)
    levels.push_back({{"cells", level.cells},
                      {"unknowns", level.unknowns},
                      {"status", name_of(level.trial.status)},
                      {"error", level.error},
                      {"order", level.order},
                      {"solver_error", level.trial.estimate},
                      {"cpu_seconds", level.trial.cpu_seconds}});
  return {{"part", d->part},
          {"order", d->order},
          {"steady", d->steady},
          {"against", d->steady ? "extrapolation" : "finest mesh"},
          {"levels", levels}};
}

}  // namespace

std::string comparison_csv(const Comparison& c) {
  std::string text =
      "kind,method,tolerance,cells,unknowns,status,error_m,estimate_m,cpu_s,in_factorisations,iterations,"
      "factorisations,residuals,solves,reference,other_equilibrium,steps,rejected_steps\n";
  for (const auto& m : c.methods)
    for (const Trial& t : m.trials) text += trial_csv(c, m, t);
  if (c.discretisation)
    for (const auto& level : c.discretisation->levels) text += mesh_csv(level);
  return text;
}

std::string comparison_json(const Comparison& c) {
  const char* status = c.is_interrupted ? "interrupted" : c.any_converged() ? "done" : "not converged";
  const auto dumped = [](const Json& all) { return all.dump(2, ' ', false, Json::error_handler_t::replace); };
  if (c.is_of_motions) return dumped(motions_json(c, status));
  Json methods = Json::array();
  for (const auto& m : c.methods) methods.push_back(method_json(c, m));
  const Json all = {{"status", status},
                    {"scene", c.scene},
                    {"mesh", c.mesh},
                    {"unknowns", c.unknowns},
                    {"repeats", c.repeats},
                    {"size", c.size},
                    {"factorisation_seconds", c.factorisation_seconds},
                    {"methods", methods},
                    {"discretisation", discretisation_json(c.discretisation)}};
  return dumped(all);
}

}  // namespace netloft::studies
