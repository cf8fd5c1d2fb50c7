// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

namespace netloft::scenes {

/// Parameters that the program recognises by name in the elements of any plugin, and whose values it checks,
/// draws or scales. Authors of plugins find this table in framework/guides/element.md; a test compares the
/// two.
struct KnownParameter {
  const char *name, *use;
};

namespace parameter {

inline constexpr KnownParameter kTwineDiameter{"twine.diameter", "is less than a bar, and is drawn"};
inline constexpr KnownParameter kRopeDiameter{
    "rope.diameter", "is less than 1 m and than the rope is long, is drawn, and scaled in models"};
inline constexpr KnownParameter kFloatDiameter{"float.diameter",
                                               "fits volume and buoyancy, is drawn, and scaled in models"};
inline constexpr KnownParameter kFloatArea{"float.area", "is scaled in models"};
inline constexpr KnownParameter kRopeDensity{"rope.density",
                                             "is that of a material or a chain, and scaled in models"};
inline constexpr KnownParameter kRopeSurface{"rope.surface", "if not 0, no model by Tauti's rule"};
inline constexpr KnownParameter kTwineSurface{"twine.surface", "if not 0, no model by Tauti's rule"};
inline constexpr KnownParameter kBoxHeight{"box.height", "if not 0, no model by Tauti's rule"};
inline constexpr KnownParameter kTwineEI{"twine.EI", "resists the opening of meshes"};
inline constexpr KnownParameter kOpeningStiffness{"twine.opening_stiffness", "resists the opening of meshes"};
inline constexpr KnownParameter kOpeningAngle{"twine.opening_angle",
                                              "has no effect where nothing resists the opening of meshes"};
inline constexpr KnownParameter kBedDepth{"seabed.depth",
                                          "a plane of ground, from which heights are counted"};
inline constexpr KnownParameter kBedSlopeX{"seabed.slope_x", "of that plane"};
inline constexpr KnownParameter kBedSlopeY{"seabed.slope_y", "of that plane"};
inline constexpr KnownParameter kBedSoftness{"seabed.softness", "how deep a gear may begin in that plane"};
inline constexpr KnownParameter kLengthShare{"rope.length_share",
                                             "of a warp on a winch; is a fraction, not in per cent"};
inline constexpr KnownParameter kTwineDensity{"twine.density", "is that of a material"};
inline constexpr KnownParameter kTwineEA{"twine.EA", "is no less than EA_compression"};
inline constexpr KnownParameter kTwineEACompression{"twine.EA_compression", "is no greater than EA"};
inline constexpr KnownParameter kRopeEA{"rope.EA", "is no less than EA_compression"};
inline constexpr KnownParameter kRopeEACompression{"rope.EA_compression", "is no greater than EA"};
inline constexpr KnownParameter kFloatBuoyancy{"float.buoyancy", "is compared with that of volume and mass"};
inline constexpr KnownParameter kFloatVolume{"float.volume", "makes a buoyancy with the mass"};
inline constexpr KnownParameter kFloatMass{"float.mass", "makes a buoyancy with the volume"};

inline constexpr std::array kKnown = {
    kTwineDiameter,      kRopeDiameter, kFloatDiameter,     kFloatArea,        kRopeDensity,  kRopeSurface,
    kTwineSurface,       kBoxHeight,    kTwineEI,           kOpeningStiffness, kOpeningAngle, kBedDepth,
    kBedSlopeX,          kBedSlopeY,    kBedSoftness,       kLengthShare,      kTwineDensity, kTwineEA,
    kTwineEACompression, kRopeEA,       kRopeEACompression, kFloatBuoyancy,    kFloatVolume,  kFloatMass};

}  // namespace parameter
}  // namespace netloft::scenes
