// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/stretch_damping.hpp"

#include "framework/parameters/find_number.hpp"

namespace netloft::runs {

namespace {

/// The value of the stiffness parameter of the part whose unit, multiplied by seconds, is that of `damping`;
/// nullptr if there is none.
const double* find_stiffness(const Part& part, const ElementType& type, const netloft_parameter& damping) {
  for (const netloft_parameter& p : type.parameters) {
    if (!(p.flags & NETLOFT_STIFFNESS) || std::string(p.unit) + " s" != damping.unit) continue;
    if (part.parameters.contains(p.name)) return find_number(part.parameters, p.name);
  }
  return nullptr;
}

}  // namespace

void damp_stretch(Scene& scene, Registry& registry, double beta) {
  for (Part& part : scene.parts) {
    const ElementType& type = registry.element(part.type);
    for (const netloft_parameter& p : type.parameters) {
      if (!(p.flags & NETLOFT_DAMPING) || part.parameters.contains(p.name)) continue;
      if (const double* EA = find_stiffness(part, type, p)) part.parameters[p.name] = beta * *EA;  // (1)
    }
  }
}

}  // namespace netloft::runs
