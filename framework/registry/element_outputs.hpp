// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"

#include <array>
#include <string_view>

namespace netloft {

/// An output that reports and pictures recognise by its name and unit, in elements of any plugin.
/// guides/element.md lists the same outputs for authors; a test compares both lists. Outputs that are
/// tensions or doubts are recognised by their roles instead (netloft_output_role).
struct KnownOutput {
  const char *name, *unit, *use;
};

namespace output {

inline constexpr KnownOutput kMass{"mass", "kg", "mass in air, summed up by rope and panel"};
inline constexpr KnownOutput kTwineArea{"twine_area", "m2",
                                        "length times diameter of twines: summed up by panel"};
inline constexpr KnownOutput kKnots{"knots", "1",
                                    "number of knots, by which the opening of meshes is weighted"};
inline constexpr KnownOutput kHalfAngle{"half_angle", "rad",
                                        "half the angle between the twines of a mesh: its opening"};
inline constexpr KnownOutput kDrag{"drag", "N", "force of the water: drawn by length and area"};
inline constexpr KnownOutput kStrain{
    "strain", "1", "strain, from which unstretched lengths follow when a result is made into a mesh"};
inline constexpr KnownOutput kNormalForce{
    "normal_force", "N", "force of the ground on a node: shows which nodes touch the bed, and how hard"};
inline constexpr KnownOutput kGap{"gap", "m",
                                  "height over the ground, negative where a node touches it: shows which "
                                  "nodes are about to touch or leave it"};
inline constexpr KnownOutput kPressure{"pressure", "Pa",
                                       "pressure of a catch on netting: shows where to draw the catch"};
inline constexpr KnownOutput kVolume{"volume", "m3", "volume of a catch in the element"};

inline constexpr KnownOutput kInduction{"induction", "1",
                                        "fraction of its speed that the water loses in the bag of a net"};
inline constexpr KnownOutput kMouthArea{
    "mouth_area", "m2", "contribution of an element to the area through which water enters a bag"};

inline constexpr std::array kKnown = {kMass,     kTwineArea, kKnots,       kHalfAngle,
                                      kDrag,     kStrain,    kNormalForce, kGap,
                                      kPressure, kVolume,    kInduction,   kMouthArea};

}  // namespace output

inline bool is_output(const netloft_output& one, const KnownOutput& known) {
  return std::string_view(one.name) == known.name && std::string_view(one.unit) == known.unit;
}
inline bool is_tension(const netloft_output& one) { return one.role == NETLOFT_OUTPUT_TENSION; }

}  // namespace netloft
