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

std::vector<Company> find_companies(std::span<const std::unique_ptr<ElementFamily>> families) {
  std::vector<Company> companies;
  for (std::size_t f = 0; f < families.size(); ++f) {
    const auto at = std::find_if(companies.begin(), companies.end(), [&](const Company& company) {
      return have_same_nodes(*families[company.families.front()], *families[f]);
    });
    Company& company = at == companies.end() ? companies.emplace_back() : *at;
    company.families.push_back(f);
  }
  return companies;
}

}  // namespace netloft
