// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft::pictures {

/// The bytes of letters/noto-sans-subset.ttf, which CMakeLists.txt embeds in the program.
extern const unsigned char kFontFile[];
extern const std::size_t kFontFileSize;

}  // namespace netloft::pictures
