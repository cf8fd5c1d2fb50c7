# SPDX-License-Identifier: BSD-3-Clause
# The font as bytes in the program.
set(font picture/letters/noto-sans-subset.ttf)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${font})
file(READ ${font} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
file(CONFIGURE OUTPUT font_file.cpp CONTENT "// SPDX-License-Identifier: BSD-3-Clause
#include \"io/pictures/picture/font_file.hpp\"

namespace netloft::pictures {
const unsigned char kFontFile[] = {
@bytes@};
const std::size_t kFontFileSize = sizeof kFontFile;
}
" @ONLY)
