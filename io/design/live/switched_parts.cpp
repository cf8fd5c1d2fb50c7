// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/live/switched_parts.hpp"

#include "io/studies/sensitivity/switches.hpp"

#include <algorithm>
#include <map>

namespace netloft::design {

namespace {

constexpr std::size_t kMostPartsNamed = 4;  // a longer list would not be read

struct SwitchedGroup {
  std::string words;
  std::size_t count;
};

/// Counts, for each part, the members or nodes whose `distance` became negative, and those whose `distance`
/// became zero or positive.
void add_switched(const Scene& scene, const studies::Switches::OfKind& before,
                  const studies::Switches::OfKind& after, const std::string& things, const char* to_below,
                  const char* to_above, std::vector<SwitchedGroup>& groups) {
  std::map<std::string, std::size_t> counts;
  if (before.part != after.part) return;
  for (std::size_t i = 0; i < before.distance.size(); ++i) {
    const bool was_below = before.distance[i] < 0, is_below = after.distance[i] < 0;
    if (was_below != is_below)
      ++counts[things + " of " + scene.parts[before.part[i]].name + (is_below ? to_below : to_above)];
  }
  for (const auto& [words, count] : counts) groups.push_back({words, count});
}

}  // namespace

std::string switched_parts(runs::PreparedScene& before, const std::vector<double>& x_before,
                           runs::PreparedScene& after, const std::vector<double>& x_after) {
  if (!runs::have_same_topology(before, after))
    return "its net is divided into other elements, so that slack members and touching nodes cannot be "
           "compared";
  const Scene& scene = after.loaded().scene;
  const auto then = studies::switches_at(before.loaded().scene, before.assembler(), x_before);
  const auto now = studies::switches_at(scene, after.assembler(), x_after);
  std::vector<SwitchedGroup> groups;
  add_switched(scene, then.members, now.members, "members", " became slack", " became taut", groups);
  add_switched(scene, then.nodes, now.nodes, "nodes", " touched the ground", " left the ground", groups);
  if (groups.empty())
    return "no member became slack or taut, and no node touched or left the ground: the gear jumped to "
           "another equilibrium, or bends too much for its derivatives to describe";
  std::ranges::stable_sort(groups, std::ranges::greater{}, &SwitchedGroup::count);
  std::string text;
  for (std::size_t i = 0; i < std::min(groups.size(), kMostPartsNamed); ++i)
    text += (text.empty() ? "" : "; ") + std::to_string(groups[i].count) + " " + groups[i].words;
  return text;
}

}  // namespace netloft::design
