// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/switches.hpp"

#include "framework/assembler/members.hpp"
#include "framework/assembler/reports.hpp"
#include "framework/registry/element_outputs.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

double chord_length(const netloft_member& member, const ElementFamily& family, std::size_t element,
                    const std::vector<double>& positions) {
  double chord[3] = {0, 0, 0};
  for (int corner = 0; corner < std::min(3, family.nodes_per_element()); ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis)
      chord[axis] += member.c[corner] * positions[3 * std::size_t{family.node(element, corner)} + axis];
  return std::hypot(chord[0], chord[1], chord[2]);
}

void add_members(const ElementFamily& family, const std::vector<double>& positions, Switches::OfKind& to) {
  const std::vector<netloft_member> members = members_of(family);
  const std::size_t each = family.type().members.count;
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (members[m].EA == members[m].EA_compression) continue;
    to.distance.push_back(chord_length(members[m], family, m / each, positions) / members[m].rest_length - 1);
    to.part.push_back(family.part(m / each));
  }
}

void add_nodes(const Scene& scene, Assembler& assembler, std::size_t f, std::span<const double> x,
               Switches::OfKind& to) {
  const ElementFamily& family = *assembler.families()[f];
  const auto& outputs = family.type().outputs;
  const auto gap = std::ranges::find_if(outputs, [](auto& one) { return is_output(one, output::kGap); });
  if (gap == outputs.end()) return;
  std::vector<std::vector<double>> values;
  assembler.reports().outputs(x, f, values);
  const auto& gaps = values[static_cast<std::size_t>(gap - outputs.begin())];
  for (std::size_t e = 0; e < family.size(); ++e) {
    to.distance.push_back(gaps[e]);
    to.part.push_back(scene.labels[family.node(e, 0)].part);
  }
}

std::map<std::string, std::size_t> changes_of(const Scene& scene, const Switches::OfKind& at,
                                              const Switches::OfKind& above, const Switches::OfKind& below,
                                              double ratio) {
  std::map<std::string, std::size_t> changes;
  if (above.part != at.part || below.part != at.part) return changes;
  for (std::size_t i = 0; i < at.distance.size(); ++i) {
    const double way = ratio * std::abs(above.distance[i] - below.distance[i]);
    if (way > 0 && way >= std::abs(at.distance[i])) ++changes[scene.parts[at.part[i]].name];  // (1)
  }
  return changes;
}

std::size_t count_below(const Switches::OfKind& one) {
  return static_cast<std::size_t>(std::ranges::count_if(one.distance, [](double d) { return d < 0; }));
}

}  // namespace

Switches switches_at(const Scene& scene, Assembler& assembler, std::span<const double> x) {
  Switches all;
  const std::vector<double> positions = assembler.node_positions(x);
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    if (has_members(*assembler.families()[f])) add_members(*assembler.families()[f], positions, all.members);
    add_nodes(scene, assembler, f, x, all.nodes);
  }
  return all;
}

SwitchSides sides_of(const Switches& at) {
  return {at.members.distance.size(), count_below(at.members), at.nodes.distance.size(),
          count_below(at.nodes)};
}

SwitchChanges switch_changes(const Scene& scene, const Switches& at, const Switches& above,
                             const Switches& below, double distance, double change) {
  const double ratio = change / distance;
  return {changes_of(scene, at.members, above.members, below.members, ratio),
          changes_of(scene, at.nodes, above.nodes, below.nodes, ratio)};
}

}  // namespace netloft::studies
