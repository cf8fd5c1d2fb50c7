// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/plugins.hpp"
#include "io/program/session/components.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/terminal.hpp"
#include "io/scenes/reading/dynamics.hpp"
#include "io/scenes/reading/keys.hpp"

#include <fmt/format.h>

namespace netloft::program {

namespace {

void print_json(const Json& json) { print_line(json.dump(2, ' ', false, Json::error_handler_t::replace)); }

/// Describes a table that belongs to no plugin: "water", "waves", "tow", "bed", "analysis" or "gear".
int describe_keys(const std::string& name, std::span<const netloft_parameter> table, bool json) {
  if (json) {
    print_json({{"type", name}, {"kind", "table"}, {"parameters", parameter_json(table)}});
    return kDone;
  }
  print_line("[" + name + "]: a table of the scene\n" + parameter_text(table));
  return kDone;
}

/// The keys of the analysis, including those of motions.
std::vector<netloft_parameter> all_analysis_keys() {
  std::vector<netloft_parameter> all(scenes::analysis_keys().begin(), scenes::analysis_keys().end());
  all.insert(all.end(), scenes::dynamics_keys().begin(), scenes::dynamics_keys().end());
  return all;
}

}  // namespace

int list_command(const PluginOptions& options) {
  Registry registry;
  find_plugins(options, registry);
  Json rows = Json::array();
  std::string refused;
  for (const auto& name : registry.available()) try {
      for (const auto& c : components_of(registry.plugin(name))) {
        rows.push_back({{"type", c.type}, {"kind", c.kind}, {"doc", c.doc}});
        if (!options.json) print_line(fmt::format("{:<24} {:<8} {}", c.type, c.kind, c.doc));
      }
    } catch (const PluginRefused& e) {
      refused += std::string(e.what()) + "\n";
    }
  if (options.json) print_json({{"components", rows}, {"refused", refused}});
  if (!refused.empty()) Terminal(options).say(refused);
  return refused.empty() ? kDone : kRefused;
}

int describe_command(const DescribeOptions& options) {
  if (options.type == "water") return describe_keys("water", scenes::water_keys(), options.json);
  if (options.type == "waves") return describe_keys("waves", scenes::wave_keys(), options.json);
  if (options.type == "tow") return describe_keys("tow", scenes::tow_keys(), options.json);
  if (options.type == "bed") return describe_keys("bed", scenes::bed_keys(), options.json);
  if (options.type == "analysis") return describe_keys("analysis", all_analysis_keys(), options.json);
  if (options.type == "gear") return describe_keys("gear", scenes::gear_keys(), options.json);
  Registry registry;
  find_plugins(options, registry);
  const bool whole = options.type.find('/') == std::string::npos;
  Json all = Json::array();
  for (const auto& c : components_of(registry.plugin(options.type.substr(0, options.type.find('/'))))) {
    if (!whole && c.type != options.type) continue;
    all.push_back(c.json());
    if (!options.json) print_line(c.text());
  }
  if (all.empty()) registry.element(options.type);  // throws with a list of the known types
  if (options.json) print_json(all.size() == 1 ? all[0] : all);
  return kDone;
}

}  // namespace netloft::program
