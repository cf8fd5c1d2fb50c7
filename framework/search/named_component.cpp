// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/named_component.hpp"

#include "framework/search/search.hpp"

#include <netloft/strategy.hpp>

#include <stdexcept>
#include <string_view>

namespace netloft {

namespace {

bool names(const netloft_parameter& p, std::string_view kind) {
  return p.kind == NETLOFT_TEXT && p.unit == kind;
}

struct NamedComponent {
  std::string type;
  std::span<const netloft_parameter> parameters;
};

NamedComponent find_component(const std::string& name, const netloft_parameter& named_by,
                              Registry& registry) {
  const auto of = [](const auto& type) { return NamedComponent{type.type, type.parameters}; };
  return names(named_by, "solver") ? of(registry.solver(name)) : of(registry.strategy(name));
}

bool is_empty_by_default(const netloft_parameter& p) { return !p.fallback_text || !*p.fallback_text; }

}  // namespace

bool names_component(const netloft_parameter& p) { return names(p, "solver") || names(p, "strategy"); }

void check_named(const netloft_parameter& p, const std::string& text, Registry& registry,
                 const GivenValues& given, std::set<std::string> callers) {
  if (text.empty() && is_empty_by_default(p)) return;
  const Specification word = specification_of(text);
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(std::string(p.name) + " = \"" + text + "\" " + why + " (" + p.doc + ")");
  };
  if (word.name.empty()) refuse(std::string("names no ") + p.unit);
  const NamedComponent named = find_component(word.name, p, registry);
  if (callers.contains(named.type)) refuse("makes " + named.type + " call itself without end");
  Values values;
  if (const auto prevailing = given.find(named.type); prevailing != given.end()) {
    values = prevailing->second;
    callers.insert(named.type);
  }
  values.merge(parse_parameters(named.parameters, word.parameters));
  for (const auto& row : named.parameters)
    if (const auto value = values.find(row.name); value != values.end() && names_component(row))
      check_named(row, std::get<std::string>(value->second), registry, given, callers);
}

std::vector<const StrategyType*> strategies_named_by(const StrategyType& strategy, const Values& values,
                                                     Registry& registry, const GivenValues& given) {
  std::vector<const StrategyType*> all;
  for (const auto& row : strategy.parameters) {
    if (!names(row, "strategy")) continue;
    const auto value = values.find(row.name);
    const std::string text = value != values.end() ? std::get<std::string>(value->second)
                             : row.fallback_text   ? row.fallback_text
                                                   : "";
    const Specification word = specification_of(text);
    if (word.name.empty()) continue;
    const StrategyType& named = registry.strategy(word.name);
    const auto prevailing = given.find(named.type);
    Values own = prevailing == given.end() ? Values{} : prevailing->second;
    own.merge(parse_parameters(named.parameters, word.parameters));
    all.push_back(&named);
    const auto further = strategies_named_by(named, own, registry, given);
    all.insert(all.end(), further.begin(), further.end());
  }
  return all;
}

}  // namespace netloft
