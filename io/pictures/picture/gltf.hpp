// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/gear_shape.hpp"

#include <string>

namespace netloft::pictures {

/// The bytes of a binary glTF 2.0 file (.glb): a named node for every part, with triangles, lines and points
/// in the colours of the shape, in metres, y up. Half a gear appears twice, the second time mirrored.
std::string glb(const GearShape& shape);

}  // namespace netloft::pictures
