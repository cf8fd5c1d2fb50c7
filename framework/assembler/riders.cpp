// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/riders.hpp"

#include <unordered_map>

namespace netloft {

namespace {

/// A hash of the nodes of a family: FNV-1a over words instead of bytes.
std::uint64_t hash_of_nodes(const ElementFamily& family) {
  constexpr std::uint64_t kBasis = 14695981039346656037u, kPrime = 1099511628211u;
  const int nodes = family.all_nodes_per_element();
  std::uint64_t hash = (kBasis ^ static_cast<std::uint64_t>(nodes)) * kPrime;
  for (std::size_t e = 0; e < family.size(); ++e)
    for (int n = 0; n < nodes; ++n) hash = (hash ^ family.node(e, n)) * kPrime;
  return hash;
}

}  // namespace

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
  std::unordered_multimap<std::uint64_t, std::size_t> known;  // hash of the nodes -> index of the group
  for (std::size_t f = 0; f < families.size(); ++f) {
    const std::uint64_t hash = hash_of_nodes(*families[f]);
    auto [at, end] = known.equal_range(hash);
    while (at != end && !have_same_nodes(*families[groups[at->second].families.front()], *families[f])) ++at;
    if (at == end) {
      at = known.emplace(hash, groups.size());
      groups.emplace_back();
    }
    FamilyGroup& group = groups[at->second];
    group.families.push_back(f);
    for (const netloft_term& term : families[f]->active_terms()) group.traits |= term.traits;
  }
  return groups;
}

}  // namespace netloft
