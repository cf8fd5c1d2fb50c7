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
  double solver_error = kUnknown;  // change of the value in one more Newton step
  double mesh_error = kUnknown;    // estimated difference from the limit of ever finer meshes
  double mesh_order = kUnknown;    // observed order of convergence
  // Range over all equilibria that were found, if there were several.
  double least = kUnknown, largest = kUnknown;
  // At an unstable equilibrium: change of the value along the motion that grows, per metre of the largest
  // displacement of a node.
  double per_swing = kUnknown;
};

/// Finds a number by its name; nullptr if there is none.
const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name);

}  // namespace netloft::results
