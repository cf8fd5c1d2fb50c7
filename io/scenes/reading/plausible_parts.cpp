// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/plausible_parts.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::scenes {

namespace {

// Osmium is the densest element (CRC Handbook of Chemistry and Physics, 97th edition, section 4). A density
// in t/m3 is below 23.
constexpr double kDensestElement = 22590, kSteel = 7850;  // [kg/m3]
// A chain is modelled as a cylinder with the diameter of the wire of its links. Chains of the library
// therefore have 25 000 to 28 000 kg/m3, and footropes with rollers or chain loops up to 30 000 kg/m3.
// Nothing is denser than a chain of osmium.
constexpr double kHeaviestChain = 28000, kDensestRope = kHeaviestChain * kDensestElement / kSteel;
// Cork has 120 to 240 kg/m3 (L. J. Gibson and M. F. Ashby, Cellular Solids, 1997). The lightest solid fibre,
// polypropylene, has 910 kg/m3. 0 means a rope without mass.
constexpr double kLightestMaterial = 100;  // [kg/m3]
// The thickest ropes moor ships and platforms, and have a diameter of 0.3 m.
constexpr double kThickestRope = 1;  // [m]
// Tolerance for the buoyancy of floats: catalogues round buoyancy, volume and mass by about 5 % each.
constexpr double kRoundingOfFloats = 0.2;  // fraction of the weight of the displaced water [1]
// Volume of a float, divided by that of a sphere of its diameter: 1 in the library, 20 for a round bar that
// is 13 diameters long. If litres are read as m3, the quotient is a thousand times too large.
constexpr double kLongestFloat = 20;  // [1]
// Buoyancy of a float, divided by the weight of the water that a sphere of its diameter displaces: 0.56 to
// 0.63 in the library. If kgf are read as N, the quotient is a tenth of that.
constexpr double kWeakestFloat = 0.1;  // [1]

// Mass of a float, divided by its volume. The largest inflated buoys have 20 kg/m3, floats of a net 200 to
// 500; if litres are read as m3, the quotient is a thousandth of that.
constexpr double kLightestFloat = 5;  // [kg/m3]
// Length of a warp, divided by its length at the start. The longest warps are paid out from a drum to a few
// times their initial length; if per cent are read as a fraction, the quotient is a hundred times too large.
constexpr double kMostShare = 10;  // [1]

/// The checks of one part.
class PartCheck {
 public:
  PartCheck(const LoadedScene& loaded, std::size_t p, formats::Diagnostics& diagnostics)
      : water_(loaded.scene.water),
        part_(loaded.scene.parts[p]),
        place_(loaded.parts[p].place),
        diagnostics_(diagnostics) {}

  /// Warns of a density that no material has. In air, or without gravity, a density close to zero is allowed,
  /// because it models a spring without mass.
  void check_density(const KnownParameter& known, double densest, const std::string& why) {
    const double density = number(known);
    const bool has_weight = water_.density > 0 && water_.gravity > 0;
    if (density > densest)
      warn(fmt::format("{} = {:.6g} kg/m3: {}", known.name, density, why),
           "density = 7850 is steel, 1140 polyamide, 950 polyethylene, in kg/m3");
    else if (density > 0 && density < kLightestMaterial && has_weight)
      warn(fmt::format("{} = {:.6g} kg/m3: even cork has more than {:.0f} kg/m3", known.name, density,
                       kLightestMaterial),
           fmt::format("a number without a unit is in kg/m3; density = \"{:.4g} t/m3\" states its unit; 0 is "
                       "a rope without mass",
                       density));
  }

  void check_thickness() {
    const double diameter = number(parameter::kRopeDiameter);
    if (diameter > kThickestRope)
      warn(
          fmt::format("rope.diameter = {:.4g} m: no rope is thicker than {:.0f} m", diameter, kThickestRope),
          fmt::format("a number without a unit is in m; diameter = \"{:.4g} mm\" states its unit", diameter));
  }

  /// Warns of lengths over time that are given in per cent.
  void check_length_share() {
    const auto given = part_.parameters.find(parameter::kLengthShare.name);
    const auto* rows = given == part_.parameters.end() ? nullptr : std::get_if<Samples>(&given->second);
    if (!rows) return;
    double most = 0;
    for (const auto& row : *rows) most = std::max(most, row[1]);
    if (most > kMostShare)
      warn(fmt::format("rope.length_share reaches {:.4g} times the length at the start", most),
           "share = [\"100 %\", \"50 %\"] states its unit; without one, 0.5 is half of the length");
  }

  void check_stiffness(const KnownParameter& tension, const KnownParameter& compression) {
    const double* EA = find_number(part_.parameters, tension.name);
    const double* slack = EA ? find_number(part_.parameters, compression.name) : nullptr;
    if (slack && *slack > *EA)
      diagnostics_.error(
          place_,
          fmt::format("{}: {} = {:.6g} N is greater than {} = {:.6g} N: ropes and twines are not "
                      "stiffer in compression than in tension",
                      part_.name, compression.name, *slack, tension.name, *EA),
          "EA_compression = 0 is a rope that bears no compression; leave it out for the default");
  }

  void check_float() {
    const auto first = part_.parameters.lower_bound("float.");
    const bool is_float = first != part_.parameters.end() && first->first.starts_with("float.");
    if (!is_float || water_.density == 0 || water_.gravity == 0) return;
    check_buoyancy_of_float();
    check_density_of_float();
    check_size_of_float();
  }

 private:
  double number(const KnownParameter& known) const { return number_or(0, part_.parameters, known.name); }
  double weight_of(double volume) const { return water_.density * water_.gravity * volume; }
  void warn(const std::string& message, const std::string& hint) {
    diagnostics_.warning(place_, part_.name + ": " + message, hint);
  }

  /// Warns of a float whose given buoyancy does not fit its volume and mass. In any case the given buoyancy
  /// is used; volume and mass then only affect inertia. Without a mass, any buoyancy up to the weight of the
  /// displaced water fits.
  void check_buoyancy_of_float() {
    const double given = number(parameter::kFloatBuoyancy), volume = number(parameter::kFloatVolume),
                 mass = number(parameter::kFloatMass);
    const double lift = weight_of(volume), follows = lift - mass * water_.gravity;
    if (given == 0 || lift == 0) return;
    const double off = mass > 0 ? std::abs(given - follows) : given - lift;
    if (off <= kRoundingOfFloats * lift) return;
    warn(fmt::format("float.buoyancy = {:.4g} N is used; float.volume = {:.4g} m3 with float.mass = {:.4g} "
                     "kg would give {:.4g} N, but volume and mass count in motions only",
                     given, volume, mass, follows),
         "leave buoyancy out, so that it follows from volume and mass, or leave volume out");
  }

  /// Warns of a float whose mass does not fit its volume. Floats without volume are weights, and not checked.
  void check_density_of_float() {
    const double volume = number(parameter::kFloatVolume), mass = number(parameter::kFloatMass);
    if (volume == 0 || mass == 0) return;
    const double density = mass / volume;
    if (density >= kLightestFloat && density <= kDensestElement) return;
    warn(fmt::format("float.mass = {:.4g} kg in float.volume = {:.4g} m3 makes {:.4g} kg/m3, and floats and "
                     "weights have {:.0f} to {:.0f} kg/m3",
                     mass, volume, density, kLightestFloat, kDensestElement),
         "a number without a unit is in kg or m3; mass = \"1.63 kg\" and volume = \"4.19 L\" state their "
         "units");
  }

  /// Warns of a float whose volume or buoyancy does not fit its diameter.
  void check_size_of_float() {
    const double diameter = number(parameter::kFloatDiameter), buoyancy = number(parameter::kFloatBuoyancy),
                 volume = number(parameter::kFloatVolume);
    const double sphere = std::numbers::pi / 6 * std::pow(diameter, 3);
    if (sphere == 0) return;
    const double displaced = std::max(volume, buoyancy / weight_of(1));
    if (displaced > kLongestFloat * sphere)
      warn(fmt::format("the float displaces {:.4g} m3, but a sphere of its diameter {:.4g} m3", displaced,
                       sphere),
           "a number without a unit is in m3, N or m; volume = \"4.19 L\" and buoyancy = \"2.7 kgf\" state "
           "their units");
    else if (buoyancy > 0 && buoyancy < kWeakestFloat * weight_of(sphere))
      warn(fmt::format("float.buoyancy = {:.4g} N, and the water that a sphere of its diameter displaces "
                       "weighs {:.4g} N",
                       buoyancy, weight_of(sphere)),
           fmt::format("a number without a unit is in N; buoyancy = \"{:.4g} kgf\" states its unit",
                       buoyancy));
  }

  const SceneWater& water_;
  const Part& part_;
  const formats::Place& place_;
  formats::Diagnostics& diagnostics_;
};

}  // namespace

void check_plausible_parts(const LoadedScene& loaded, formats::Diagnostics& diagnostics) {
  const std::string chain = fmt::format(
      "even a chain, as a cylinder of its wire's diameter, has no more than {:.0f} kg/m3", kHeaviestChain);
  const std::string element = fmt::format("osmium, the densest element, has {:.0f} kg/m3", kDensestElement);
  for (std::size_t p = 0; p < loaded.parts.size(); ++p) {
    PartCheck part(loaded, p, diagnostics);
    part.check_density(parameter::kRopeDensity, kDensestRope, chain);
    part.check_density(parameter::kTwineDensity, kDensestElement, element);
    part.check_thickness();
    part.check_length_share();
    part.check_stiffness(parameter::kRopeEA, parameter::kRopeEACompression);
    part.check_stiffness(parameter::kTwineEA, parameter::kTwineEACompression);
    part.check_float();
  }
}

}  // namespace netloft::scenes
