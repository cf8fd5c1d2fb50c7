// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/tauti.hpp"

#include "io/scenes/reading/known_parameters.hpp"

#include <cmath>

namespace netloft::scenes {

namespace {

double* number_in(Part& part, const KnownParameter& known) {
  const auto given = part.parameters.find(known.name);
  return given == part.parameters.end() ? nullptr : std::get_if<double>(&given->second);
}

}  // namespace

double TautiModel::viscosity_of_netting() const { return std::pow(twines, 1.5); }

void TautiModel::scale_ropes_and_floats(Scene& scene) const {
  const double ratio = lengths / twines;
  for (Part& part : scene.parts) {
    double* const rope = number_in(part, parameter::kRopeDiameter);
    double* const floats = number_in(part, parameter::kFloatDiameter);
    double* const area = number_in(part, parameter::kFloatArea);
    if (!rope && !floats && !area) continue;
    part.viscosity_ratio = ratio;
    if (rope) *rope *= std::sqrt(ratio);
    if (double* const density = number_in(part, parameter::kRopeDensity))
      *density = scene.water.density + (*density - scene.water.density) / ratio;
    if (floats) *floats *= std::cbrt(ratio);
    if (area) *area *= std::cbrt(ratio * ratio);
  }
}

const Part* find_part_above_water(const Scene& scene) {
  for (const Part& part : scene.parts)
    for (const auto& known : {parameter::kRopeSurface, parameter::kTwineSurface, parameter::kBoxHeight})
      if (const auto given = part.parameters.find(known.name);
          given != part.parameters.end() && given->second != Value(0.0))
        return &part;
  return nullptr;
}

}  // namespace netloft::scenes
