// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/stretch_damping.hpp"

namespace netloft::io {

namespace {

const std::string kDamping = ".damping", kStiffness = ".EA";

void damp(Part& part, const netloft_parameter& damping, double beta) {
  const std::string name = damping.name;
  if (!name.ends_with(kDamping) || part.parameters.contains(name)) return;
  const auto stiffness = part.parameters.find(name.substr(0, name.size() - kDamping.size()) + kStiffness);
  if (stiffness == part.parameters.end()) return;
  part.parameters[name] = beta * std::get<double>(stiffness->second);  // (1)
}

}  // namespace

void damp_stretch(Scene& scene, Registry& registry, double beta) {
  for (Part& part : scene.parts)
    for (const netloft_parameter& p : registry.element(part.type).parameters) damp(part, p, beta);
}

}  // namespace netloft::io
