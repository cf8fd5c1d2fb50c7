// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::pictures {

/// The bytes of letters/noto-sans-subset.ttf, put into the program by CMakeLists.txt.
extern const unsigned char kFontFile[];

}  // namespace netloft::pictures
