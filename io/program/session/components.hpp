// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace netloft::program {

using Json = nlohmann::ordered_json;

/// One component of any kind, as a row of `list`, as a page and as JSON.
struct Component {
  std::string type, kind, doc;
  std::function<std::string()> text;
  std::function<Json()> json;
};

std::vector<Component> components_of(const PluginContent& plugin);

/// The parameters of a component, one per row of its table, as JSON or as text.
Json parameter_json(std::span<const netloft_parameter> table);
std::string parameter_text(std::span<const netloft_parameter> table);

/// JSON schema of scene files, from the tables of all available plugins.
Json scene_schema(Registry& registry);

}  // namespace netloft::program
