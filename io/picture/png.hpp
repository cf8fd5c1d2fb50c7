// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/picture/canvas.hpp"

#include <string>

namespace netloft::io {

/// The bytes of a PNG file (ISO/IEC 15948), eight bits a colour.
std::string png(const Image& image);

}  // namespace netloft::io
