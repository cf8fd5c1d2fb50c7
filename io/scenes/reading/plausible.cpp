// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/plausible.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::scenes {

namespace {

// Fresh water has 1000 kg/m3, the Dead Sea 1240 kg/m3. A density of 0, for air, is allowed, too.
constexpr double kLightestWater = 900, kHeaviestWater = 1250;  // [kg/m3]
// The diameter of a chain is that of the wire of its links; a cylinder of this diameter has 25 000 to 28 000
// kg/m3 (chains of the library). Footropes of the library whose density includes rollers or chain loops have
// up to 30 000 kg/m3.
constexpr double kHeaviestChain = 28000, kDensest = 50000;  // [kg/m3]
// This speed is 20 kn. Gears are towed at up to 6 kn; at higher speeds drag breaks them.
constexpr double kFastestTow = 10;  // [m/s]
// This speed is 39 kn. A ship in a heavy sea moves its blocks by less than 5 m/s.
constexpr double kFastestHold = 20;  // [m/s]
// A residual of 1 % of the largest load changes results by more than the differences between gears that
// people compare.
constexpr double kCoarsestTolerance = 0.01;  // [1]
// Tolerance for the buoyancy of floats: catalogues round buoyancy, volume and mass by about 5 % each.
constexpr double kRoundingOfFloats = 0.2;  // fraction of the weight of the displaced water [1]

void check_water(const LoadedScene& loaded, formats::TableReader& root) {
  const double density = loaded.scene.water.density;
  if (density == 0 || (density >= kLightestWater && density <= kHeaviestWater)) return;
  root.diagnostics().warning(
      root.table("water").place("density"),
      fmt::format("water.density = {:.4g} kg/m3: water has {:.0f} to {:.0f} kg/m3", density, kLightestWater,
                  kHeaviestWater),
      "sea water is density = \"1.025 t/m3\", or 1025 without a unit; density = 0 is air");
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
  double speed = 0;
  for (const auto& sample : loaded.scene.current.samples)
    speed = std::max(speed, std::hypot(sample.velocity[0], sample.velocity[1], sample.velocity[2]));
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

void check_density(const Part& part, const KnownParameter& known, const formats::Place& place,
                   formats::Diagnostics& diagnostics) {
  const double density = number_or(0, part.parameters, known.name);
  if (density > kDensest)
    diagnostics.warning(place,
                        fmt::format("{}: {} = {:.6g} kg/m3: even a chain, as a cylinder of its wire's "
                                    "diameter, has no more than {:.0f} kg/m3",
                                    part.name, known.name, density, kHeaviestChain),
                        "density = 7850 is steel, 1140 polyamide, 950 polyethylene, in kg/m3");
}

void check_stiffness(const Part& part, const KnownParameter& tension, const KnownParameter& compression,
                     const formats::Place& place, formats::Diagnostics& diagnostics) {
  const double* EA = find_number(part.parameters, tension.name);
  const double* slack = find_number(part.parameters, compression.name);
  if (EA && slack && *slack > *EA)
    diagnostics.error(place,
                      fmt::format("{}: {} = {:.6g} N is greater than {} = {:.6g} N: ropes and twines are not "
                                  "stiffer in compression than in tension",
                                  part.name, compression.name, *slack, tension.name, *EA),
                      "EA_compression = 0 is a rope that bears no compression; leave it out for the default");
}

/// Warns of a float whose given buoyancy does not fit its volume and mass, which then count for its inertia
/// only. If no mass is given, any buoyancy up to the weight of the displaced water fits.
void check_float(const LoadedScene& loaded, const Part& part, const formats::Place& place,
                 formats::Diagnostics& diagnostics) {
  const double given = number_or(0, part.parameters, parameter::kFloatBuoyancy.name),
               volume = number_or(0, part.parameters, parameter::kFloatVolume.name),
               mass = number_or(0, part.parameters, parameter::kFloatMass.name);
  const SceneWater& water = loaded.scene.water;
  const double lift = water.density * volume * water.gravity, follows = lift - mass * water.gravity;
  if (given == 0 || lift == 0) return;
  const double off = mass > 0 ? std::abs(given - follows) : given - lift;
  if (off <= kRoundingOfFloats * lift) return;
  diagnostics.warning(
      place,
      fmt::format("{}: float.buoyancy = {:.4g} N is used; float.volume = {:.4g} m3 with float.mass = {:.4g} "
                  "kg would give {:.4g} N, and they count in motions alone",
                  part.name, given, volume, mass, follows),
      "leave buoyancy out to have it from volume and mass, or leave volume out");
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
  formats::Diagnostics& diagnostics = root.diagnostics();
  check_water(loaded, root);
  check_tolerance(loaded, root);
  check_tow_speed(loaded, root);
  check_current_speed(loaded, root);
  for (std::size_t p = 0; p < loaded.parts.size(); ++p) {
    const Part& part = loaded.scene.parts[p];
    const formats::Place& place = loaded.parts[p].place;
    check_density(part, parameter::kRopeDensity, place, diagnostics);
    check_density(part, parameter::kTwineDensity, place, diagnostics);
    check_stiffness(part, parameter::kRopeEA, parameter::kRopeEACompression, place, diagnostics);
    check_stiffness(part, parameter::kTwineEA, parameter::kTwineEACompression, place, diagnostics);
    check_float(loaded, part, place, diagnostics);
  }
}

}  // namespace netloft::scenes
