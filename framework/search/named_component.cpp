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

std::span<const netloft_parameter> table_of(const std::string& name, const netloft_parameter& named_by,
                                            Registry& registry) {
  if (names(named_by, "solver")) return registry.solver(name).parameters;
  return registry.strategy(name).parameters;
}

bool is_empty_by_default(const netloft_parameter& p) { return !p.fallback_text || !*p.fallback_text; }

}  // namespace

bool names_component(const netloft_parameter& p) { return names(p, "solver") || names(p, "strategy"); }

void check_named(const netloft_parameter& p, const std::string& text, Registry& registry) {
  if (text.empty() && is_empty_by_default(p)) return;
  const Specification word = specification_of(text);
  if (word.name.empty())
    throw std::invalid_argument(std::string(p.name) + " = \"" + text + "\" names no " + p.unit + " (" +
                                p.doc + ")");
  const auto table = table_of(word.name, p, registry);
  const Values values = parse_parameters(table, word.parameters);
  for (const auto& row : table)
    if (const auto given = values.find(row.name); given != values.end() && names_component(row))
      check_named(row, std::get<std::string>(given->second), registry);
}

}  // namespace netloft
