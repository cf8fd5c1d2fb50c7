// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/motion_report.hpp"

#include "io/results/text/gear_json.hpp"
#include "io/results/text/gear_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>

namespace netloft::results {

double real_time_factor(const MotionResult& result) {
  const double wall = result.march.statistics.total_seconds;
  return wall > 0 ? (result.march.t - result.resumed_from) / wall : 0;
}

namespace {

/// How far from rest it began; empty for a run that went on.
std::string start_text(const scenes::LoadedScene& loaded, const StartBalance& s) {
  if (s.node.empty()) return "";
  const scenes::Dynamics& d = loaded.analysis.dynamics;
  const std::string from = d.from_equilibrium     ? "the equilibrium"
                           : d.start_file.empty() ? "the sketch"
                                                  : d.start_file.filename().string();
  return fmt::format(
      "  began at rest, from {}: forces out of balance by at most {:.3g} N, at {} "
      "(largest load {:.3g} N)\n",
      from, s.residual, s.node, s.load);
}

/// What the scheme took, where it is too much to speak of one motion.
std::string loss_text(const std::optional<NumericalLoss>& l) {
  if (!l || !l->is_large()) return "";
  if (l->is_created())
    return fmt::format(
        "  warning: the scheme created {:.3g} J, and {:.3g} J were given: the motion is too lively\n"
        "  a smaller accuracy creates less, and energy-momentum creates none\n",
        -l->lost, l->given);
  return fmt::format(
      "  warning: the scheme took {:.3g} J of the {:.3g} J that were given, most of it ({:.3g} J) between t "
      "= {:.4g} "
      "and {:.4g} s, at {};\n  what follows depends on the scheme: damping of the stretch (rope.damping, "
      "stiffness_damping) lets a finer accuracy tell\n",
      l->lost, l->given, l->worst, l->from, l->until, l->node);
}

nlohmann::ordered_json loss_json(const std::optional<NumericalLoss>& l) {
  if (!l) return nullptr;
  return {{"lost", l->lost},   {"given", l->given}, {"is_large", l->is_large()},
          {"worst", l->worst}, {"from", l->from},   {"until", l->until},
          {"node", l->node}};
}

/// Why no accuracy gives the whole path.
std::string chaos_text(const AchievedAccuracy& a) {
  return fmt::format(
      "  warning: the motion is chaotic: a start displaced by 1e-7 of an element leads to another path from "
      "t = {:.4g} s on, and no accuracy gives the path after that;\n  envelopes, energies and peaks of "
      "several runs agree where ropes and twines have a damping\n",
      a.unpredictable_from);
}

/// The error of the path, and whether that is what was asked for.
std::string path_text(const AchievedAccuracy& a) {
  if (!a.is_checked) return "";
  if (std::isnan(a.path))
    return "  warning: the path is not known: the march that it is compared with took the same steps\n";
  if (!std::isfinite(a.path))
    return fmt::format(
        "  warning: the path is not known: the march in other steps that it is compared with "
        "was lost at t = {:.4g} s ({})\n",
        a.path_at, a.path_of);
  if (a.path == 0) return "  error of the path: none against a march in other steps\n";
  const bool is_more = !(a.path <= a.asked);
  return fmt::format(
             "  {}error of the path{} {:.3g}, at t = {:.4g} s at {}, against a march in other steps{}\n",
             is_more ? "warning: " : "", a.is_predictable() ? "" : " until it cannot be predicted", a.path,
             a.path_at, a.path_of, is_more ? ": more than was asked for" : "") +
         (a.is_predictable() ? "" : chaos_text(a));
}

/// What was asked for and what errors of steps came to; empty: steps were given.
std::string accuracy_text(const AchievedAccuracy& a) {
  if (a.asked == 0) return "";
  std::string text = fmt::format("  accuracy {:.3g} asked", a.asked);
  if (!a.node.empty())
    text += fmt::format(
        ", {:.3g} allowed for one step; {:.3g} at most, at t = {:.4g} s at {}, {:.3g} of all steps together",
        a.allowed, a.largest, a.t, a.node, a.sum);
  return text + fmt::format(" (over the longest element, {:.3g} m)\n", a.element) + path_text(a);
}

nlohmann::ordered_json path_json(const AchievedAccuracy& a) {
  if (!a.is_checked) return nullptr;
  const bool is_known = std::isfinite(a.path);
  using Json = nlohmann::ordered_json;
  return {
      {"error", is_known ? Json(a.path) : Json(nullptr)},
      {"time", a.path_at},
      {"node", is_known ? Json(a.path_of) : Json(nullptr)},
      {"predictable_until", std::isfinite(a.unpredictable_from) ? Json(a.unpredictable_from) : Json(nullptr)},
      {"reached", !a.is_missed()}};
}

nlohmann::ordered_json accuracy_json(const AchievedAccuracy& a) {
  if (a.asked == 0) return nullptr;
  return {{"asked", a.asked},     {"longest_element", a.element},
          {"allowed", a.allowed}, {"largest", a.largest},
          {"time", a.t},          {"node", a.node},
          {"sum", a.sum},         {"path", path_json(a)}};
}

nlohmann::ordered_json start_json(const StartBalance& s) {
  if (s.node.empty()) return nullptr;
  return {{"out_of_balance", s.residual}, {"largest_load", s.load}, {"node", s.node}};
}

}  // namespace

std::string motion_text(const scenes::LoadedScene& loaded, const ScenePlan& plan, const MotionResult& r) {
  std::string text;
  const auto out = std::back_inserter(text);
  const Statistics& b = r.march.statistics;
  fmt::format_to(out, "{}: {}\n  {}\n", loaded.scene.name, name_of(r.march.status), r.march.reason);
  fmt::format_to(out, "  {} unknowns, {}, {} steps of {:.3g} to {:.3g} s, {} rejected, {} outputs\n",
                 plan.unknowns, loaded.analysis.dynamics.integrator, r.march.steps, r.march.shortest,
                 r.march.longest, r.march.rejected, r.outputs);
  fmt::format_to(out, "  {} iterations, {} factorisations, {:.3g} s, {:.3g} CPU s; real-time factor {:.3g}\n",
                 b.iterations, b.factorisations, b.total_seconds, b.total_cpu_seconds, real_time_factor(r));
  text += start_text(loaded, r.march.start) + accuracy_text(r.march.accuracy) + loss_text(r.loss);
  for (const auto& sentence : r.warnings) fmt::format_to(out, "  warning: {}\n", sentence);
  if (r.march.stable_step > 0)
    fmt::format_to(out, "  stable for steps up to {:.3g} s, with all members taut\n", r.march.stable_step);
  for (const auto& s : r.scalars)
    fmt::format_to(out, "  {:<24} {:>18.10g} {:<8} {}\n", s.name, s.value, s.unit == "1" ? "" : s.unit,
                   s.doc + ", at the end");
  for (const auto& [name, joules] : r.energies) fmt::format_to(out, "  {:<24} {:>18.6g} J\n", name, joules);
  text += gear_text(r.gear, loaded.gear && loaded.gear->times == 2);
  if (!r.output_file.empty())
    fmt::format_to(out, "  written to {}{}\n", r.output_file,
                   r.march.status == MarchStatus::interrupted ? "; --resume goes on from there" : "");
  return text;
}

std::string motion_json(const scenes::LoadedScene& loaded, const ScenePlan& plan, const MotionResult& r) {
  using Json = nlohmann::ordered_json;
  const Statistics& b = r.march.statistics;
  Json results = Json::object(), units = Json::object(), energies = Json::object();
  for (const auto& s : r.scalars) {
    results[s.name] = s.value;
    units[s.name] = s.unit;
  }
  for (const auto& [name, joules] : r.energies) energies[name] = joules;
  const Json json = {{"scene", loaded.scene.name},
                     {"status", name_of(r.march.status)},
                     {"reason", r.march.reason},
                     {"time", r.march.t},
                     {"resumed_from", r.resumed_from},
                     {"integrator", loaded.analysis.dynamics.integrator},
                     {"solver", loaded.analysis.solver},
                     {"unknowns", plan.unknowns},
                     {"steps", r.march.steps},
                     {"rejected_steps", r.march.rejected},
                     {"shortest_step", r.march.shortest},
                     {"longest_step", r.march.longest},
                     {"stable_step", r.march.stable_step},
                     {"accuracy", accuracy_json(r.march.accuracy)},
                     {"warnings", r.warnings},
                     {"numerical_loss", loss_json(r.loss)},
                     {"start", start_json(r.march.start)},
                     {"outputs", r.outputs},
                     {"iterations", b.iterations},
                     {"residuals", b.residuals},
                     {"factorisations", b.factorisations},
                     {"wall_seconds", b.total_seconds},
                     {"cpu_seconds", b.total_cpu_seconds},
                     {"real_time_factor", real_time_factor(r)},
                     {"results", results},
                     {"units", units},
                     {"energies", energies},
                     {"gear", gear_json(loaded, r.gear)},
                     {"output", r.output_file.empty() ? Json(nullptr) : Json(r.output_file)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::results
