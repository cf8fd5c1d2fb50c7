// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/idle_keys.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

bool is_set(const Part& part, const char* name) {
  const auto at = part.parameters.find(name);
  const double* value = at == part.parameters.end() ? nullptr : std::get_if<double>(&at->second);
  return value && *value != 0;
}

bool meshes_resist(const Part& part) {
  return is_set(part, "twine.EI") || is_set(part, "twine.opening_stiffness");
}

}  // namespace

void check_idle_keys(const Part& part, TableReader& table) {
  if (is_set(part, "twine.opening_angle") && !meshes_resist(part))
    table.error("twine", "opening_angle has no effect: nothing draws the meshes to it",
                "EI or opening_stiffness of the twine, or leave it out");
}

void check_turned_netting(const Part& part, const Place& place, Diagnostics& diagnostics) {
  if (!meshes_resist(part))
    diagnostics.warning(
        place, part.name + ": t90 netting whose meshes resist no opening hangs as diamond netting does",
        "EI or opening_stiffness of the twine, which hold meshes open along their knots");
}

}  // namespace netloft::io
