// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace netloft::formats {

/// Powers of the base units, "kg" → 1, "m" → -3. The radian counts as a base unit, so that 45 deg is not a
/// pure number and N.m/deg is never taken for N.m.
using Dimension = std::map<std::string, int>;

struct DimensionName {
  Dimension dimension;
  std::string unit;  // in the notation of designers: "kg/m3"
  std::string name;  // with its article: "a density"
};

/// The entry for a dimension; one without a name of its own is called "a quantity".
DimensionName describe(const Dimension& dimension);

}  // namespace netloft::formats
