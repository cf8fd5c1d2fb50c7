// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/easier.hpp"

#include <algorithm>
#include <cstring>

namespace netloft {

double value_of(const Part& part, const ElementType& type, const netloft_parameter& parameter) {
  std::vector<std::string> faults;
  const ParameterBlock block(type.parameters, type.element.parameter_bytes, part.parameters, faults);
  return faults.empty() ? block.number(parameter) : 0.0;
}

bool is_in_newtons(const netloft_parameter& parameter) { return std::strcmp(parameter.unit, "N") == 0; }

namespace {

/// Calls visit(part, type, parameter) for every real parameter that has the role.
template <class PartOf, class Visit>
void for_role(PartOf& parts, Registry& registry, std::uint32_t role, Visit&& visit) {
  for (auto& part : parts) {
    const ElementType& type = registry.element(part.type);
    for (const auto& parameter : type.parameters)
      if (parameter.flags & role) visit(part, type, parameter);
  }
}

/// Largest stiffness in newtons of the parts of each name; a part and its companions share a name.
std::map<std::string, double> stiffness_by_name(const Scene& scene, Registry& registry) {
  std::map<std::string, double> largest;
  for_role(scene.parts, registry, NETLOFT_STIFFNESS, [&](const Part& part, const auto& type, const auto& p) {
    if (is_in_newtons(p)) largest[part.name] = std::max(largest[part.name], value_of(part, type, p));
  });
  return largest;
}

}  // namespace

std::optional<Scene> without_compression(const Scene& scene, Registry& registry) {
  Scene easier = scene;
  bool changed = false;
  for_role(easier.parts, registry, NETLOFT_COMPRESSION, [&](Part& part, const auto& type, const auto& p) {
    changed |= value_of(part, type, p) > 0;
    part.parameters[p.name] = 0.0;
  });
  if (!changed) return {};
  return easier;
}

Scene softened(const Scene& scene, Registry& registry, double cap) {
  const auto largest = stiffness_by_name(scene, registry);
  Scene easier = scene;
  for_role(easier.parts, registry, NETLOFT_STIFFNESS | NETLOFT_COMPRESSION,
           [&](Part& part, const auto& type, const auto& p) {
             const auto own = largest.find(part.name);
             if (own == largest.end() || own->second <= cap) return;
             // A default that follows another stiffness follows it by itself.
             const bool given = part.parameters.contains(p.name) || !p.fallback_of;
             const double value = value_of(part, type, p);
             if (given && value > 0) part.parameters[p.name] = std::max(p.lo, value * (cap / own->second));
           });
  return easier;
}

double largest_stiffness(const Scene& scene, Registry& registry) {
  double largest = 0;
  for (const auto& [name, stiffness] : stiffness_by_name(scene, registry))
    largest = std::max(largest, stiffness);
  return largest;
}

Scene with_current(const Scene& scene, double share) {
  Scene easier = scene;
  const auto scale = [share](auto& samples) {
    for (auto& sample : samples)
      for (double& component : sample.velocity) component *= share;
  };
  scale(easier.current.samples), scale(easier.current.drifts);
  return easier;
}

}  // namespace netloft
