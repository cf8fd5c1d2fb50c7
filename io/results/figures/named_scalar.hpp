// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <vector>

namespace netloft::results {

/// A number that is reported by its name, with its errors. NaN marks unknown ones.
struct NamedScalar {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::string name, unit, doc;
  double value = 0;
  double solver_error = kUnknown;               // its change by the next Newton step
  double mesh_error = kUnknown;                 // bound of the distance from the limit of finer meshes
  double mesh_order = kUnknown;                 // observed order of convergence
  double least = kUnknown, largest = kUnknown;  // over all equilibria that were found, if there were several
  double per_swing = kUnknown;  // its change for each metre that the furthest node of a growing motion moves
};

/// Returns null if none has this name.
const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name);

}  // namespace netloft::results
