// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/idle_keys.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/scenes/reading/known_parameters.hpp"

namespace netloft::scenes {

namespace {

bool is_set(const Part& part, const KnownParameter& known) {
  return number_or(0, part.parameters, known.name) != 0;
}

bool meshes_resist(const Part& part) {
  return is_set(part, parameter::kTwineEI) || is_set(part, parameter::kOpeningStiffness);
}

}  // namespace

void check_idle_keys(const Part& part, formats::TableReader& table) {
  if (is_set(part, parameter::kOpeningAngle) && !meshes_resist(part))
    table.error("twine", "opening_angle has no effect, because the meshes have no stiffness against opening",
                "give EI or opening_stiffness of the twine, or leave opening_angle out");
}

void check_turned_netting(const Part& part, const formats::Place& place, formats::Diagnostics& diagnostics) {
  if (!meshes_resist(part))
    diagnostics.warning(
        place, part.name + ": t90 netting whose meshes resist no opening hangs as diamond netting does",
        "give the twine EI or opening_stiffness, which hold meshes open along their knots");
}

}  // namespace netloft::scenes
