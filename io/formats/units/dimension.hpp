// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace netloft::formats {

/// Powers of the base units, such as "kg" → 1, "m" → -3. The radian counts as a base unit, so that 45 deg is
/// not a pure number and N.m/deg is not the same as N.m.
using Dimension = std::map<std::string, int>;

struct DimensionName {
  Dimension dimension;
  std::string unit;  // unit in engineering notation: "kg/m3"
  std::string name;  // name with its article: "a density"
};

/// The SI unit and the name of a dimension. The name is "a quantity" if there is no special name.
DimensionName describe(const Dimension& dimension);

}  // namespace netloft::formats
