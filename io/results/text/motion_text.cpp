// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/motion_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

using Json = nlohmann::ordered_json;

/// Says how far from equilibrium the motion began; empty if that is not known.
std::string start_text(const Motion& m) {
  if (!m.start) return "";
  return fmt::format(
      "  began at rest, from {}: forces out of balance by at most {:.3g} N, at {} (largest load {:.3g} N)\n",
      m.start_from, m.start->residual, m.start->node, m.start->load);
}

/// A warning if the time scheme has removed or added so much energy that it affects the motion; otherwise
/// empty.
std::string loss_text(const std::optional<NumericalLoss>& l) {
  if (!l || !l->is_large()) return "";
  if (l->is_created())
    return fmt::format(
        "  warning: the time scheme created {:.3g} J, while {:.3g} J were supplied: the motion is too "
        "lively\n"
        "  with a smaller accuracy it creates less energy, and the integrator energy-momentum creates none\n",
        -l->lost, l->given);
  return fmt::format(
      "  warning: the time scheme removed {:.3g} J of the {:.3g} J that were supplied, most of it ({:.3g} J) "
      "between t "
      "= {:.4g} "
      "and {:.4g} s, at {};\n  the motion after that depends on the scheme; give ropes a damping of stretch "
      "(rope.damping, stiffness_damping), so that a smaller accuracy improves it\n",
      l->lost, l->given, l->worst, l->from, l->until, l->node);
}

/// A warning that the motion is chaotic, so that no accuracy gives the whole path.
std::string chaos_text(const AchievedAccuracy& a) {
  return fmt::format(
      "  warning: the motion is chaotic: a start displaced by 1e-7 of an element leads to another path from "
      "t = {:.4g} s on, and no accuracy gives the path after that;\n  envelopes, energies and peaks of "
      "several runs agree where ropes and twines have a damping\n",
      a.unpredictable_from);
}

/// The error of the path, and whether it meets the requested accuracy. For a chaotic motion, it is the error
/// up to the time after which the motion cannot be predicted; it is unknown if no output can be predicted.
std::string error_text(const AchievedAccuracy& a) {
  const char* until = a.is_predictable() ? "" : " until it cannot be predicted";
  if (std::isnan(a.path) && !a.is_predictable()) return "";
  if (std::isnan(a.path))
    return "  warning: the error of the path is not known: the second run, for comparison, took the same "
           "steps\n";
  if (!std::isfinite(a.path))
    return fmt::format(
        "  warning: the error of the path is not known: the second run, with other steps for comparison, was "
        "lost at t = {:.4g} s ({})\n",
        a.path_at, a.path_of);
  if (a.path == 0)
    return fmt::format("  error of the path{}: none, compared with a run in other steps\n", until);
  const bool is_more = !(a.path <= a.asked);
  return fmt::format(
      "  {}error of the path{} {:.3g}, at t = {:.4g} s at {}, compared with a run in other steps{}\n",
      is_more ? "warning: " : "", until, a.path, a.path_at, a.path_of,
      is_more ? ": more than was asked for" : "");
}

/// Whether the path can be predicted, and its error.
std::string path_text(const AchievedAccuracy& a) {
  if (!a.is_checked) return "";
  return (a.is_predictable() ? "" : chaos_text(a)) + error_text(a);
}

/// The requested accuracy and the errors of steps; empty if the steps were prescribed.
std::string accuracy_text(const std::optional<AchievedAccuracy>& a) {
  if (!a) return "";
  std::string text = fmt::format("  accuracy of {:.3g} requested", a->asked);
  if (!a->node.empty())
    text += fmt::format(
        ", an error of {:.3g} allowed for each step; the largest error of a step was {:.3g} ({}, t = {:.4g} "
        "s), "
        "the errors of all steps add up to {:.3g}",
        a->allowed, a->largest, a->node, a->t, a->sum);
  return text + fmt::format(" (as fractions of the longest element, {:.3g} m)\n", a->element) + path_text(*a);
}

Json loss_json(const std::optional<NumericalLoss>& l) {
  if (!l) return nullptr;
  return {{"lost", l->lost},           {"given", l->given}, {"negligible", l->negligible},
          {"is_large", l->is_large()}, {"worst", l->worst}, {"from", l->from},
          {"until", l->until},         {"node", l->node}};
}

Json path_json(const AchievedAccuracy& a) {
  if (!a.is_checked) return nullptr;
  const bool is_known = std::isfinite(a.path);
  return {
      {"error", is_known ? Json(a.path) : Json(nullptr)},
      {"time", a.path_at},
      {"node", is_known ? Json(a.path_of) : Json(nullptr)},
      {"predictable_until", std::isfinite(a.unpredictable_from) ? Json(a.unpredictable_from) : Json(nullptr)},
      {"reached", !a.is_missed()}};
}

Json accuracy_json(const std::optional<AchievedAccuracy>& a) {
  if (!a) return nullptr;
  return {{"asked", a->asked},     {"longest_element", a->element},
          {"allowed", a->allowed}, {"largest", a->largest},
          {"time", a->t},          {"node", a->node},
          {"sum", a->sum},         {"path", path_json(*a)}};
}

Json start_json(const std::optional<StartBalance>& s) {
  if (!s) return nullptr;
  return {{"out_of_balance", s->residual}, {"largest_load", s->load}, {"node", s->node}};
}

}  // namespace

double real_time_factor(const Result& result) {
  const double wall = result.statistics.total_seconds;
  return wall > 0 ? result.motion->time / wall : 0;
}

std::string motion_text(const Result& result) {
  const Motion& m = *result.motion;
  std::string text;
  const auto out = std::back_inserter(text);
  if (m.steps > 0)
    fmt::format_to(out, "  {}, {} steps of {:.3g} to {:.3g} s, {} rejected; real-time factor {:.3g}\n",
                   m.integrator, m.steps, m.shortest, m.longest, m.rejected, real_time_factor(result));
  text += start_text(m) + accuracy_text(m.accuracy) + loss_text(m.loss);
  if (m.stable_step > 0)
    fmt::format_to(out, "  stable for steps up to {:.3g} s, with all members taut\n", m.stable_step);
  for (const auto& [name, joules] : m.energies) fmt::format_to(out, "  {:<24} {:>18.6g} J\n", name, joules);
  if (result.outcome == "interrupted") fmt::format_to(out, "  --resume goes on from there\n");
  return text;
}

Json motion_json(const Result& result) {
  const Motion& m = *result.motion;
  return {{"time", m.time},
          {"resumed_from", m.resumed_from},
          {"integrator", m.integrator},
          {"steps", m.steps},
          {"rejected_steps", m.rejected},
          {"shortest_step", m.shortest},
          {"longest_step", m.longest},
          {"stable_step", m.stable_step},
          {"accuracy", accuracy_json(m.accuracy)},
          {"numerical_loss", loss_json(m.loss)},
          {"start", start_json(m.start)},
          {"outputs", result.states},
          {"real_time_factor", real_time_factor(result)},
          {"energies", m.energies}};
}

}  // namespace netloft::results
