// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/axial_members.hpp"

#include <cmath>
#include <string_view>

namespace netloft::io {

namespace {

constexpr double kNextToNothing = 1e-12;  // of the stiffness

/// How a type of element calls its stiffnesses.
struct Naming {
  std::string_view type, EA, EA_compression;
};
constexpr Naming kRope{"rope/bar", "rope.EA", "rope.EA_compression"};
constexpr Naming kNetting{"priour/triangle", "twine.EA", "twine.EA_compression"};

const Naming* naming_of(const Part& part) {
  for (const Naming* naming : {&kRope, &kNetting})
    if (part.type == naming->type) return naming;
  return nullptr;
}

double value_of(const Part& part, const ElementType& type, std::string_view name) {
  std::vector<std::string> faults;
  const ParameterBlock block(type.parameters, type.element.parameter_bytes, part.parameters, faults);
  for (const auto& parameter : type.parameters)
    if (faults.empty() && name == parameter.name) return block.number(parameter);
  return 0;
}

void add_bars(std::vector<AxialMember>& members, const Part& rope, AxialMember member) {
  const auto& lengths = rope.data.at("rest_length");
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    member.node = {rope.nodes[2 * e], rope.nodes[2 * e + 1], 0};
    member.c = {-1, 1, 0};
    member.l0 = lengths[e];
    members.push_back(member);
  }
}

/// The two directions of twines of each triangle (plugins/priour/triangle.hpp, (1) to (3)).
void add_twines(std::vector<AxialMember>& members, const Part& netting, AxialMember member) {
  const auto& lengths = netting.data.at("bar_length");
  member.nodes = 3;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const double *u = &netting.data.at("u")[3 * e], *v = &netting.data.at("v")[3 * e];
    const double d = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
    member.node = {netting.nodes[3 * e], netting.nodes[3 * e + 1], netting.nodes[3 * e + 2]};
    member.l0 = lengths[e], member.count = std::abs(d) / 2;
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
    const Naming* naming = naming_of(part);
    if (!naming) continue;
    const ElementType& type = registry.element(part.type);
    AxialMember member;
    member.part = p;
    member.EA = value_of(part, type, naming->EA);
    member.EA_compression = value_of(part, type, naming->EA_compression);
    (naming == &kRope ? add_bars : add_twines)(members, part, member);
  }
  return members;
}

Scene without_axial_stiffness(const Scene& scene, Registry& registry) {
  Scene loose = scene;
  for (Part& part : loose.parts)
    if (const Naming* naming = naming_of(part)) {
      const ElementType& type = registry.element(part.type);
      for (const auto name : {naming->EA, naming->EA_compression})
        part.parameters[std::string(name)] = kNextToNothing * value_of(part, type, name);
    }
  return loose;
}

}  // namespace netloft::io
