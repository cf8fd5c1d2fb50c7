// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/riders.hpp"

#include <algorithm>

namespace netloft {

bool have_same_nodes(const ElementFamily& a, const ElementFamily& b) {
  const int nodes = a.all_nodes_per_element();
  if (a.size() != b.size() || nodes != b.all_nodes_per_element()) return false;
  for (std::size_t e = 0; e < a.size(); ++e)
    for (int n = 0; n < nodes; ++n)
      if (a.node(e, n) != b.node(e, n)) return false;
  return true;
}

std::vector<FamilyGroup> find_family_groups(std::span<const std::unique_ptr<ElementFamily>> families) {
  std::vector<FamilyGroup> groups;
  for (std::size_t f = 0; f < families.size(); ++f) {
    const auto at = std::find_if(groups.begin(), groups.end(), [&](const FamilyGroup& group) {
      return have_same_nodes(*families[group.families.front()], *families[f]);
    });
    FamilyGroup& group = at == groups.end() ? groups.emplace_back() : *at;
    group.families.push_back(f);
    for (const netloft_term& term : families[f]->active_terms()) group.traits |= term.traits;
  }
  return groups;
}

}  // namespace netloft
