// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/water_checks.hpp"

#include "io/scenes/water/current.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft::scenes {

namespace {

struct Heights {
  double low, high;  // [m]
  std::string text() const { return fmt::format("z = {:.4g} m to {:.4g} m", low, high); }
};

Heights heights_of(const Scene& scene) {
  Heights gear{scene.positions[2], scene.positions[2]};
  for (std::size_t i = 2; i < scene.positions.size(); i += 3) {
    gear.low = std::min(gear.low, scene.positions[i]);
    gear.high = std::max(gear.high, scene.positions[i]);
  }
  return gear;
}

/// Warns of a current profile that is entirely above the surface, above the gear or below the gear. Beyond
/// its heights a profile is constant, so that the gear would meet only one of its values.
void check_profile(const Scene& scene, formats::TableReader& root) {
  const auto& profile = scene.current.samples;
  if (scene.current.is_uniform() || scene.positions.empty()) return;
  const Heights gear = heights_of(scene), table{profile.front().z, profile.back().z};
  const bool is_dry = table.low >= 0, is_above = table.low > gear.high, is_below = table.high < gear.low;
  if (!is_dry && !is_above && !is_below) return;
  const char* where = is_below                 ? "below the gear"
                      : table.low >= gear.high ? "above the gear"
                                               : "above the surface";
  formats::TableReader current = root.table("water").table("current");
  current.diagnostics().warning(
      current.place("z"),
      fmt::format("water.current: the profile lies {} ({}; the gear starts at {}), so that only its {} value "
                  "acts",
                  where, table.text(), gear.text(), is_below ? "highest" : "lowest"),
      "z points up and is 0 at the surface: a depth of 50 m is z = \"-50 m\"");
}

/// Warns of a current that has the velocity of the tow, at all heights and at some time. The water would then
/// pass the gear twice as fast as intended.
void check_tow(const Scene& scene, formats::TableReader& root) {
  // Two velocities are equal if they differ by less than this fraction of the towing speed. Gears are rarely
  // towed through a current that happens to have the same velocity.
  constexpr double kAlike = 0.02;
  Current current = scene.current;
  const auto tow = std::exchange(current.tow, {});
  const double speed = std::hypot(tow[0], tow[1]);
  if (speed == 0) return;
  const auto is_alike = [&](const auto& v) {
    return std::hypot(v[0] - tow[0], v[1] - tow[1]) <= kAlike * speed;
  };
  const auto all = velocities_at_kinks(current);
  if (std::ranges::none_of(all, [&](const auto& v) { return std::ranges::all_of(v, is_alike); })) return;
  root.diagnostics().warning(
      root.table("water").place("current"),
      fmt::format(
          "water.current repeats the speed of the tow, so that the water passes the gear at {:.4g} m/s",
          2 * speed),
      "leave water.current out: [tow] or [ship] alone moves the water and the ground past the gear");
}

}  // namespace

void check_current(const Scene& scene, formats::TableReader& root) {
  check_profile(scene, root);
  check_tow(scene, root);
}

}  // namespace netloft::scenes
