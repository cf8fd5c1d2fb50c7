// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <vector>

namespace netloft::results {

/// A number that is reported by its name, with its errors. NaN means unknown.
struct NamedScalar {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::string name, unit, doc;
  double value = 0;
  double solver_error = kUnknown;  // change of the value by the next Newton step
  double mesh_error = kUnknown;    // bound of the distance from the limit under mesh refinement
  double mesh_order = kUnknown;    // observed order of convergence
  // Range over all equilibria that were found, if there were several.
  double least = kUnknown, largest = kUnknown;
  // Change of the value per metre of movement of the furthest node of a growing motion.
  double per_swing = kUnknown;
};

/// Returns null if no number has this name.
const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name);

}  // namespace netloft::results
