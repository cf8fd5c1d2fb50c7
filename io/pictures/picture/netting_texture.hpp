// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

#include <array>
#include <optional>

namespace netloft::pictures {

/// One mesh of netting as a texture that repeats in U and V, with rows along V. Twines are dark and gaps are
/// white, so that twines darken the colours under the texture. `axes` are a, b, c, d: twines lie where u = a
/// U + b V or v = c U + d V is an integer. `half_width` is half the width of a twine, in the units of u and
/// v. nullopt if the pattern of twines does not repeat with U and V.
std::optional<Image> netting_texture(const std::array<double, 4>& axes, double half_width);

}  // namespace netloft::pictures
