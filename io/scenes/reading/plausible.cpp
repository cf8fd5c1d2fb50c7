// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/plausible.hpp"

#include "io/formats/units/degrees.hpp"
#include "io/scenes/reading/plausible_parts.hpp"
#include "io/scenes/water/current.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft::scenes {

namespace {

// Fresh water has 1000 kg/m3, the Dead Sea 1240 kg/m3. A density of 0, for air, is allowed, too.
constexpr double kLightestWater = 900, kHeaviestWater = 1250;  // [kg/m3]
// Water has a viscosity of 1.83e-6 m2/s at 0 degC with 35 g/kg of salt, of 0.6e-6 m2/s at 45 degC without
// salt (ITTC 7.5-02-01-03, 2011). The dynamic viscosity, in Pa s, is a thousand times greater.
constexpr double kThinnestWater = 0.55e-6, kThickestWater = 2e-6;  // [m2/s]
// Gravity on the ground is 9.780 m/s2 at the equator and 9.832 m/s2 at the poles (WGS 84), often rounded to
// 10. A gravity of 0, for a scene without weight, is allowed, too.
constexpr double kLeastGravity = 9.75, kMostGravity = 10;  // [m/s2]
// A slope of 1 is 45 degrees. The slopes of the continents have 3 to 6 degrees, walls of canyons up to 45
// degrees.
constexpr double kSteepestBed = 1;  // [1]
// A speed of 10 m/s is 20 kn. Gears are towed at up to 6 kn; at higher speeds drag breaks them.
constexpr double kFastestTow = 10;  // [m/s]
// A speed of 20 m/s is 39 kn. A ship in a heavy sea moves its blocks by less than 5 m/s.
constexpr double kFastestHold = 20;  // [m/s]
// A residual of 1 % of the largest load changes results by more than the differences between the gears that
// users compare.
constexpr double kCoarsestTolerance = 0.01;  // [1]

void check_water(const LoadedScene& loaded, formats::TableReader& root) {
  const double density = loaded.scene.water.density;
  if (density == 0 || (density >= kLightestWater && density <= kHeaviestWater)) return;
  root.diagnostics().warning(
      root.table("water").place("density"),
      fmt::format("water.density = {:.4g} kg/m3: water has {:.0f} to {:.0f} kg/m3", density, kLightestWater,
                  kHeaviestWater),
      "sea water is density = \"1.025 t/m3\", or 1025 without a unit; density = 0 is air");
}

/// Warns of the viscosity of a scene. (A model test scales the viscosity, but only after this check.)
void check_viscosity(const LoadedScene& loaded, formats::TableReader& root) {
  formats::TableReader water = root.table("water", formats::Presence::optional);
  if (loaded.scene.water.density == 0 || !water.has("viscosity")) return;
  const double viscosity = water.real("viscosity", {.unit = "m2/s"});
  if (viscosity >= kThinnestWater && viscosity <= kThickestWater) return;
  root.diagnostics().warning(
      water.place("viscosity"),
      fmt::format("water.viscosity = {:.4g} m2/s: water has {:.2g} to {:.2g} m2/s", viscosity, kThinnestWater,
                  kThickestWater),
      "give the kinematic viscosity, not the dynamic one: viscosity = \"1.19 mm2/s\" in the sea");
}

void check_gravity(const LoadedScene& loaded, formats::TableReader& root) {
  const double gravity = loaded.scene.water.gravity;
  if (gravity == 0 || (gravity >= kLeastGravity && gravity <= kMostGravity)) return;
  root.diagnostics().warning(
      root.table("water").place("gravity"),
      fmt::format("water.gravity = {:.4g} m/s2: on Earth it is 9.78 to 9.83 m/s2", gravity),
      "gravity = \"32.2 ft/s2\" states its unit; gravity = 0 is a scene without weight; left out, it is the "
      "standard 9.80665 m/s2");
}

void check_slopes(const LoadedScene& loaded, formats::TableReader& root) {
  const SeaBed& bed = loaded.scene.bed;
  for (const auto& [key, slope] : {std::pair{"slope_x", bed.slope_x}, std::pair{"slope_y", bed.slope_y}})
    if (std::abs(slope) > kSteepestBed)
      root.diagnostics().warning(
          root.table("bed").place(key),
          fmt::format(
              "bed.{} = {:.4g}: the bed would rise by that many metres in a metre, or by {:.3g} degrees", key,
              slope, formats::kDegreesPerRadian * std::atan(slope)),
          fmt::format("a slope of 5 % is {} = \"5 %\", or 0.05", key));
}

void check_tolerance(const LoadedScene& loaded, formats::TableReader& root) {
  const double tolerance = loaded.analysis.limits.tolerance;
  if (!(tolerance > kCoarsestTolerance)) return;
  root.diagnostics().warning(
      root.table("analysis").place("tolerance"),
      fmt::format("analysis.tolerance = {:.3g}: a force of up to {:.3g} % of the largest load may be left at "
                  "any node, and shapes and forces are no more certain than that",
                  tolerance, 100 * tolerance),
      "tolerance = 1e-6, or leave it out for the default");
}

void check_tow_speed(const LoadedScene& loaded, formats::TableReader& root) {
  const auto& ground = loaded.scene.ground;
  const double speed = std::hypot(ground[0], ground[1]);
  if (!(speed > kFastestTow)) return;
  const char* key = root.has("ship") ? "ship" : "tow";
  root.diagnostics().warning(
      root.table(key).place("speed"),
      fmt::format("{}.speed = {:.4g} m/s, which is {:.3g} kn: no gear is towed so fast", key, speed,
                  speed * 3600 / 1852),
      fmt::format("a number without a unit is in m/s; for knots, speed = \"{:.4g} kn\"", speed));
}

void check_current_speed(const LoadedScene& loaded, formats::TableReader& root) {
  Current current = loaded.scene.current;
  current.tow = {};
  double speed = 0;
  for (const auto& velocities : velocities_at_kinks(current))
    for (const auto& v : velocities) speed = std::max(speed, std::hypot(v[0], v[1], v[2]));
  if (!(speed > kFastestTow)) return;
  root.diagnostics().warning(
      root.table("water").place("current"),
      fmt::format("water.current reaches {:.4g} m/s, which is {:.3g} kn: no gear is towed so fast, and no "
                  "current of the sea is so strong",
                  speed, speed * 3600 / 1852),
      "numbers without a unit are in m/s; for knots, write \"3 kn\"");
}

double fastest(const Course& course) {
  double speed = 0;
  for (std::size_t k = 0; k < course.knots.size(); ++k) {
    const auto& [t, d, v] = course.knots[k];
    speed = std::max(speed, std::hypot(v[0], v[1], v[2]));
    if (k == 0) continue;
    const auto& before = course.knots[k - 1];
    speed = std::max(speed,
                     std::hypot(d[0] - before.d[0], d[1] - before.d[1], d[2] - before.d[2]) / (t - before.t));
  }
  return speed;
}

}  // namespace

void check_speed_of_hold(const Course& course, formats::TableReader& hold, const char* key) {
  const double speed = fastest(course);
  if (!(speed > kFastestHold)) return;
  hold.diagnostics().warning(
      hold.place(key),
      fmt::format("{}: the hold moves at {:.4g} m/s, which is {:.3g} kn: no ship or winch is so fast",
                  hold.path(key), speed, speed * 3600 / 1852),
      "t is in s, velocity in m/s and displacement in m unless a unit is given");
}

void check_plausible(const LoadedScene& loaded, formats::TableReader& root) {
  check_water(loaded, root);
  check_viscosity(loaded, root);
  check_gravity(loaded, root);
  check_slopes(loaded, root);
  check_tolerance(loaded, root);
  check_tow_speed(loaded, root);
  check_current_speed(loaded, root);
  check_plausible_parts(loaded, root.diagnostics());
}

}  // namespace netloft::scenes
