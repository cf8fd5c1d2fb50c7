// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/dimension.hpp"

#include <algorithm>
#include <vector>

namespace netloft::formats {
namespace {

const std::vector<DimensionName>& names() {
  static const std::vector<DimensionName> table = {
      {{}, "1", "a pure number"},
      {{{"m", 1}}, "m", "a length"},
      {{{"m", 2}}, "m2", "an area"},
      {{{"m", 3}}, "m3", "a volume"},
      {{{"m", -1}}, "1/m", "a curvature"},
      {{{"rad", 1}}, "rad", "an angle"},
      {{{"s", 1}}, "s", "a time"},
      {{{"s", -1}}, "1/s", "a rate"},
      {{{"rad", 1}, {"s", -1}}, "rad/s", "a turning rate"},
      {{{"m", 1}, {"s", -1}}, "m/s", "a speed"},
      {{{"m", 1}, {"s", -2}}, "m/s2", "an acceleration"},
      {{{"m", 3}, {"s", -1}}, "m3/s", "a volume flow"},
      {{{"m", 2}, {"s", -1}}, "m2/s", "a kinematic viscosity"},
      {{{"kg", 1}}, "kg", "a mass"},
      {{{"kg", 1}, {"m", -1}}, "kg/m", "a mass per length"},
      {{{"kg", 1}, {"m", -2}}, "kg/m2", "a mass per area"},
      {{{"kg", 1}, {"m", -3}}, "kg/m3", "a density"},
      {{{"kg", 1}, {"m", 2}}, "kg.m2", "a moment of inertia"},
      {{{"kg", 1}, {"s", -1}}, "N.s/m", "a damping"},
      {{{"kg", 1}, {"m", 1}, {"s", -2}}, "N", "a force"},
      {{{"kg", 1}, {"s", -2}}, "N/m", "a stiffness"},
      {{{"kg", 1}, {"m", -1}, {"s", -2}}, "Pa", "a stress"},
      {{{"kg", 1}, {"m", -2}, {"s", -2}}, "N/m3", "a force per volume"},
      {{{"kg", 1}, {"m", 2}, {"s", -2}}, "N.m", "a moment"},
      {{{"kg", 1}, {"m", 2}, {"rad", -1}, {"s", -2}}, "N.m/rad", "a moment per angle"},
      {{{"kg", 1}, {"m", 3}, {"s", -2}}, "N.m2", "a bending stiffness"},
      {{{"kg", 1}, {"m", 2}, {"s", -3}}, "W", "a power"},
      {{{"kg", 1}, {"m", -1}, {"s", -1}}, "Pa.s", "a viscosity"},
      {{{"K", 1}}, "K", "a temperature"},
  };
  return table;
}

std::string spell(const Dimension& dimension) {
  std::string text;
  for (const auto& [base, power] : dimension) {
    if (!text.empty()) text += '.';
    text += power == 1 ? base : base + std::to_string(power);
  }
  return text;
}

}  // namespace

DimensionName describe(const Dimension& dimension) {
  const auto found = std::find_if(names().begin(), names().end(),
                                  [&](const DimensionName& entry) { return entry.dimension == dimension; });
  if (found != names().end()) return *found;
  return {dimension, spell(dimension), "a quantity"};
}

}  // namespace netloft::formats
