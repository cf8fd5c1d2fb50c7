// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// The plane of a bed that a part has in its own parameters: z = slope_x x + slope_y y - depth [m].
struct BedPlane {
  double depth = 0, slope_x = 0, slope_y = 0;
  double height(double x, double y) const { return slope_x * x + slope_y * y - depth; }
  bool operator==(const BedPlane&) const = default;
};
std::optional<BedPlane> bed_plane_of(const Part& part);

/// Reports as errors: a bed that lies above the whole gear, and two beds that push at the same node. Warns of
/// held nodes below their bed, and of beds that have different planes.
void check_beds(const LoadedScene& loaded, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
