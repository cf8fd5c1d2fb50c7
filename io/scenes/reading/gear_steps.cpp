// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/gear_steps.hpp"

#include "io/scenes/reading/part_reader.hpp"

namespace netloft::scenes {

void GearSteps::read_parts(PartReader& parts) {
  parts.read_parts(formats::Presence::required);
  parts.read_bodies();
}

}  // namespace netloft::scenes
