// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

#include <string>

namespace netloft::pictures {

/// The bytes of a PNG file (ISO/IEC 15948) with eight bits per colour.
std::string png(const Image& image);

/// A PNG file with at most 256 colours (palette.hpp). For pictures of nets, in which neighbouring pixels
/// usually differ, its size is a third of that of png().
std::string small_png(const Image& image);

}  // namespace netloft::pictures
