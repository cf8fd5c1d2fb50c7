// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/printable.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/outline.hpp"
#include "io/program/commands/gears.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/terminal.hpp"
#include "io/scenes/reading/scene_source.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace netloft::program {

namespace {

using Json = nlohmann::ordered_json;

Json finding_json(const formats::Diagnostic& finding, const formats::Diagnostics& diagnostics) {
  Json json = {{"severity", finding.severity == formats::Severity::error ? "error" : "warning"},
               {"at", diagnostics.where(finding.place)},
               {"message", finding.message}};
  if (!finding.hint.empty()) json["hint"] = finding.hint;
  if (!finding.changes.empty()) json["changes"] = finding.changes;
  if (!finding.accepted.empty()) json["reason"] = finding.accepted;
  return json;
}

Json panel_json(const gears::Panel& panel) {
  Json json = {{"name", panel.name},
               {"mesh", panel.mesh},
               {"fore", panel.count(panel.fore)},
               {"aft", panel.count(panel.aft)},
               {"depth", panel.depth}};
  for (const auto& edge : panel.outline.edges)
    json["edges"].push_back({{"name", edge.name},
                             {"meshes", edge.meshes},
                             {"from", {edge.from.x, edge.from.y}},
                             {"to", {edge.to.x, edge.to.y}}});
  return json;
}

void print_json(const gears::NetPlan& plan, const formats::Diagnostics& diagnostics, int code) {
  Json json = {{"status", code == kDone      ? "can be sewn"
                          : code == kRefused ? "plugin refused"
                                             : "wrong input"},
               {"findings", Json::array()}};
  for (const auto& finding : diagnostics.sorted())
    json["findings"].push_back(finding_json(finding, diagnostics));
  json["accepted"] = Json::array();
  for (const auto& finding : diagnostics.accepted())
    json["accepted"].push_back(finding_json(finding, diagnostics));
  json["panels"] = Json::array();
  if (code == kDone)
    for (const auto& panel : plan.panels) json["panels"].push_back(panel_json(panel));
  print_line(json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_panels(const gears::NetPlan& plan) {
  print_line(fmt::format("{:<24} {:>9} {:>8} {:>8} {:>8}  {}", "panel", "mesh [mm]", "fore", "aft", "depth",
                         "twine"));
  for (const auto& p : plan.panels)
    print_line(fmt::format("{:<24} {:>9.1f} {:>8} {:>8} {:>8}  {}", p.name, 1e3 * p.mesh,
                           gears::in_meshes(p.count(p.fore)), gears::in_meshes(p.count(p.aft)),
                           gears::in_meshes(p.depth), p.twine_name));
}

std::string counted(std::size_t number, const char* one, const char* more) {
  return fmt::format("{} {}", number, number == 1 ? one : more);
}

/// Number of ropes in the plan, without selvedges, which are netting.
std::size_t ropes_of(const gears::NetPlan& plan) {
  return static_cast<std::size_t>(std::count_if(plan.ropes.begin(), plan.ropes.end(),
                                                [](const gears::Rope& r) { return !r.is_selvedge; }));
}

void print_summary(const gears::NetPlan& plan, const formats::Diagnostics& diagnostics) {
  print_panels(plan);
  print_line(fmt::format("{}, {}, {}: {}, {}", counted(plan.panels.size(), "panel", "panels"),
                         counted(plan.joins.size(), "seam", "seams"),
                         counted(ropes_of(plan), "rope", "ropes"),
                         counted(static_cast<std::size_t>(diagnostics.errors()), "error", "errors"),
                         counted(static_cast<std::size_t>(diagnostics.warnings()), "warning", "warnings")));
}

/// The key or the part that a warning is about: "top-wing.aft", "headrope".
std::string beginning_of(const std::string& message) {
  const std::size_t colon = message.find(": "), end = std::min(colon, message.find(" is "));
  return message.substr(0, end);
}

/// One line with the accepted warnings and their reasons.
void print_accepted(const formats::Diagnostics& diagnostics) {
  const auto accepted = diagnostics.accepted();
  std::string text;
  for (const auto& warning : accepted)
    text += (text.empty() ? "" : "; ") + beginning_of(warning.message) + " (" + warning.accepted + ")";
  if (!accepted.empty())
    print_line(counted(accepted.size(), "warning", "warnings") +
               " accepted: " + formats::printable_in_line(text));
}

}  // namespace

int check_command(const CheckOptions& options) {
  Terminal terminal(options);
  Registry registry;
  find_scene_plugins(options, registry);
  const runs::CaseSource source = source_of(options);
  formats::Diagnostics diagnostics;
  bool refused = false;
  const gears::NetPlan plan = source.scene.check_plan(source.changes, registry, diagnostics, refused);
  if (diagnostics.errors() + diagnostics.warnings() > 0) terminal.say(diagnostics);
  const int code = diagnostics.errors() == 0 ? kDone : refused ? kRefused : kWrongInput;
  if (options.json)
    print_json(plan, diagnostics, code);
  else if (code == kDone)
    print_summary(plan, diagnostics);
  if (!options.json) print_accepted(diagnostics);
  return code;
}

}  // namespace netloft::program
