// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"
#include "io/pictures/picture/gear_shape.hpp"

#include <cstddef>

namespace netloft::pictures {

/// Paints netting in twines as far apart as the picture can show, ropes, floats; hidden surfaces are right in
/// every pixel.
Image paint(const GearShape& shape, const Projection& projection, std::size_t width, std::size_t height,
            const Colour& ground);

}  // namespace netloft::pictures
