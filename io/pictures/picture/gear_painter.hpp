// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"
#include "io/pictures/picture/gear_shape.hpp"

#include <cstddef>

namespace netloft::pictures {

/// Paints netting (with as many twines as the picture resolves), ropes and floats. Hidden surfaces are
/// removed in every pixel.
Image paint(const GearShape& shape, const Projection& projection, std::size_t width, std::size_t height,
            const Colour& ground);

}  // namespace netloft::pictures
