// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"

#include <string>

namespace netloft {

/// The real number that is given under this name, or nullptr.
inline const double* find_number(const Values& values, const std::string& name) {
  const auto at = values.find(name);
  return at == values.end() ? nullptr : std::get_if<double>(&at->second);
}
inline double number_or(double fallback, const Values& values, const std::string& name) {
  const double* number = find_number(values, name);
  return number ? *number : fallback;
}

}  // namespace netloft
