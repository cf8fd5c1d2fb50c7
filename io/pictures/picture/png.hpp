// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

#include <string>

namespace netloft::pictures {

/// The bytes of a PNG file (ISO/IEC 15948), eight bits a colour.
std::string png(const Image& image);

/// The same in 256 colours (palette.hpp), a third as large: for pictures of nets, whose every pixel differs
/// from the next.
std::string small_png(const Image& image);

}  // namespace netloft::pictures
