// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/axial_members.hpp"

#include "framework/continuation/easier.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace netloft::io {

namespace {

/// The stiffnesses of what is as stiff as EA where taut and as EA_c where pressed; by their roles.
struct Axial {
  const netloft_parameter *EA = nullptr, *EA_compression = nullptr;
};

std::optional<Axial> axial_of(const ElementType& type) {
  Axial axial;
  int stiffnesses = 0;
  for (const auto& parameter : type.parameters) {
    if (!is_in_newtons(parameter)) continue;
    if (parameter.flags & NETLOFT_STIFFNESS) axial.EA = &parameter, ++stiffnesses;
    if (parameter.flags & NETLOFT_COMPRESSION) axial.EA_compression = &parameter;
  }
  if (stiffnesses != 1 || !axial.EA_compression) return {};
  return axial;
}

const std::vector<double>* find_data(const Part& part, const char* name) {
  const auto at = part.data.find(name);
  return at == part.data.end() ? nullptr : &at->second;
}

void add_bars(std::vector<AxialMember>& members, const Part& rope, AxialMember member) {
  const auto *lengths = find_data(rope, "rest_length"), *parallel = find_data(rope, "parallel");
  if (!lengths) return;
  for (std::size_t e = 0; e < lengths->size(); ++e) {
    member.node = {rope.nodes[2 * e], rope.nodes[2 * e + 1], 0};
    member.c = {-1, 1, 0};
    member.l0 = (*lengths)[e], member.count = parallel ? (*parallel)[e] : 1;
    members.push_back(member);
  }
}

/// The two directions of twines of each triangle, by the twine coordinates of its corners (Priour 1999).
void add_twines(std::vector<AxialMember>& members, const Part& netting, AxialMember member) {
  const auto *lengths = find_data(netting, "bar_length"), *all_u = find_data(netting, "u"),
             *all_v = find_data(netting, "v");
  if (!lengths || !all_u || !all_v) return;
  member.nodes = 3;
  for (std::size_t e = 0; e < lengths->size(); ++e) {
    const double *u = &(*all_u)[3 * e], *v = &(*all_v)[3 * e];
    const double d = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
    member.node = {netting.nodes[3 * e], netting.nodes[3 * e + 1], netting.nodes[3 * e + 2]};
    member.l0 = (*lengths)[e], member.count = std::abs(d) / 2;
    member.c = {(v[1] - v[2]) / d, (v[2] - v[0]) / d, (v[0] - v[1]) / d};
    members.push_back(member);
    member.c = {(u[2] - u[1]) / d, (u[0] - u[2]) / d, (u[1] - u[0]) / d};
    members.push_back(member);
  }
}

}  // namespace

std::vector<AxialMember> axial_members(const Scene& scene, Registry& registry) {
  std::vector<AxialMember> members;
  for (std::uint32_t p = 0; p < scene.parts.size(); ++p) {
    const Part& part = scene.parts[p];
    const ElementType& type = registry.element(part.type);
    const auto axial = axial_of(type);
    if (!axial) continue;
    AxialMember member;
    member.part = p;
    member.EA = value_of(part, type, *axial->EA);
    member.EA_compression = value_of(part, type, *axial->EA_compression);
    if (type.element.stencil == NETLOFT_BAR) add_bars(members, part, member);
    if (type.element.stencil == NETLOFT_TRIANGLE) add_twines(members, part, member);
  }
  return members;
}

Scene without_axial_stiffness(const Scene& scene, Registry& registry, std::span<const AxialMember> members) {
  Scene loose = scene;
  std::vector<bool> done(scene.parts.size(), false);
  for (const AxialMember& member : members) {
    if (done[member.part]) continue;
    done[member.part] = true;
    Part& part = loose.parts[member.part];
    const Axial axial = *axial_of(registry.element(part.type));
    for (const netloft_parameter* stiffness : {axial.EA, axial.EA_compression})
      part.parameters[stiffness->name] = std::max(stiffness->lo, 0.0);
  }
  return loose;
}

}  // namespace netloft::io
