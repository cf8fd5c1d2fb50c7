// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/element_choice.hpp"

#include "framework/registry/wrong_kind.hpp"
#include "io/scenes/reading/idle_keys.hpp"
#include "io/scenes/reading/parameter_reader.hpp"

#include <algorithm>

namespace netloft::scenes {

void report_refusal(formats::TableReader& table, const char* key, const std::string& what) {
  const auto end = what.find('\n');
  std::string tried;
  for (auto at = end; at != std::string::npos;) {
    const auto begin = what.find_first_not_of(" \n", at);
    if (begin == std::string::npos) break;
    at = what.find('\n', begin);
    tried += (tried.empty() ? "" : "; ") + what.substr(begin, at - begin);
  }
  table.error(key, what.substr(0, end), tried);
}

std::string read_name(formats::TableReader& table, const char* key, const char* doc) {
  const std::string name = table.text(key, {.doc = doc});
  if (name.empty() && table.kind(key) == formats::Kind::text)
    table.error(key, "is empty (" + std::string(doc) + ")");
  return name;
}

std::vector<int> nodes_per_element(std::span<const ElementType* const> types) {
  std::vector<int> counts;
  for (const ElementType* type : types) counts.push_back(type->nodes());
  return counts;
}

const ElementType* ElementChoice::find(const std::string& name, formats::TableReader& table) const {
  const ElementType* type = look_up(name, table);
  if (!type || !type->is_flow()) return type;
  table.error("type", name + " changes the water, and is no part of a gear",
              "[flow] type = \"" + name + "\" uses it");
  return nullptr;
}

const ElementType* ElementChoice::find_flow(const std::string& name, formats::TableReader& table) const {
  const ElementType* type = look_up(name, table);
  if (!type || (type->is_flow() && type->element.stencil == NETLOFT_BAR)) return type;
  table.error("type", name + " does not change the water",
              "use flow/momentum, or none for undisturbed water");
  return nullptr;
}

const ElementType* ElementChoice::look_up(const std::string& name, formats::TableReader& table) const {
  if (name.empty()) return nullptr;
  try {
    return &registry_.element(name);
  } catch (const PluginRefused& e) {
    refused_ |= blames_plugin(e);
    report_refusal(table, "type", e.what());
    return nullptr;
  }
}

std::vector<const ElementType*> ElementChoice::companions_of(const ElementType& type) const {
  std::vector<const ElementType*> riders;
  const std::string own = type.element.name;
  for (const auto& e : registry_.plugin(type.origin->name).elements)
    if (e.rides_on && own == e.rides_on) riders.push_back(&e);
  return riders;
}

void ElementChoice::read(const ElementType& type, formats::TableReader& table, Part& part) const {
  part.type = type.type;
  part.parameters = read_parameters(parameters_with_companions(type), table);
  part.laws = read_laws(type, table);
  check_idle_keys(part, table);
}

/// The parameters of an element type and of its companions, each name once.
std::vector<netloft_parameter> ElementChoice::parameters_with_companions(const ElementType& type) const {
  std::vector<netloft_parameter> all = type.parameters;
  for (const auto* rider : companions_of(type))
    for (const auto& p : rider->parameters)
      if (std::none_of(all.begin(), all.end(),
                       [&](const auto& q) { return std::string_view(q.name) == p.name; }))
        all.push_back(p);
  return all;
}

/// Reads the laws of a part: `drag = "hydro/morison"`, or a table with `law` and the parameters of the law.
std::map<std::string, LawChoice> ElementChoice::read_laws(const ElementType& type,
                                                          formats::TableReader& table) const {
  std::map<std::string, LawChoice> laws;
  for (const auto& slot : type.laws) {
    if (!table.has(slot.name)) continue;
    if (table.kind(slot.name) == formats::Kind::table) {
      formats::TableReader own = table.table(slot.name);
      const std::string name = own.text("law", {.doc = slot.doc, .fallback = slot.fallback});
      if (const LawType* law = find_law(name, own, "law"))
        laws[slot.name] = {name, read_parameters(law->parameters, own)};
    } else {
      const std::string name = table.text(slot.name, {.doc = slot.doc});
      if (find_law(name, table, slot.name)) laws[slot.name] = {name, {}};
    }
  }
  return laws;
}

const LawType* ElementChoice::find_law(const std::string& name, formats::TableReader& table,
                                       const char* key) const {
  try {
    return &registry_.law(name);
  } catch (const PluginRefused& e) {
    refused_ |= blames_plugin(e);
    report_refusal(table, key, e.what());
    return nullptr;
  }
}

}  // namespace netloft::scenes
