// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/tow.hpp"

#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/parameter_reader.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes {

void read_tow(formats::TableReader tow, Scene& scene) {
  const Values values = read_parameters(tow_keys(), tow);
  std::vector<std::string> faults;
  const ParameterBlock block(tow_keys(), sizeof(TowKeys), values, faults);
  if (!faults.empty()) return;
  const auto& keys = *static_cast<const TowKeys*>(block.data());
  constexpr double kRounding = 1e-15;  // rounding error of the sine of half a turn
  const double c = std::cos(keys.leeway), s = std::sin(keys.leeway);
  scene.ground = {std::abs(c) < kRounding ? 0 : keys.speed * c, std::abs(s) < kRounding ? 0 : keys.speed * s,
                  0};
  scene.current.tow = scene.ground;
}

SeaBottom read_bed(formats::TableReader bed, Scene& scene) {
  const Values values = read_parameters(bed_keys(), bed);
  std::vector<std::string> faults;
  const ParameterBlock block(bed_keys(), sizeof(BedKeys), values, faults);
  if (!faults.empty()) return {};
  const auto& keys = *static_cast<const BedKeys*>(block.data());
  scene.bed = {true, keys.depth, keys.slope_x, keys.slope_y, Surface(keys.relief, 2)};
  return SeaBottom(values, bed);
}

StandingFriction friction_on_standing_ground(const Scene& scene, const Part& part, const ElementType& type) {
  if (scene.ground != std::array<double, 3>{}) return StandingFriction::not_asked;
  StandingFriction friction = StandingFriction::not_asked;
  for (const netloft_term& term : type.terms) {
    if (!(term.traits & NETLOFT_READS_GROUND)) continue;
    const auto needed = names_needed_by(term);
    const bool is_set = needed.empty() || std::any_of(needed.begin(), needed.end(), [&](const auto& name) {
                          return sets(part, type, name);
                        });
    if (is_set && (term.traits & NETLOFT_READS_STATE)) return StandingFriction::sticks;
    if (is_set) friction = StandingFriction::none;
  }
  return friction;
}

}  // namespace netloft::scenes
