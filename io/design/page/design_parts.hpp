// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::design {

// The parts of the page, made from the files beside this one by CMakeLists.txt.
extern const char* const kDesignBody;     // the word VIEWER marks the place of the viewer
extern const char* const kDesignStyle;    // beside that of the viewer
extern const char* const kDesignScripts;  // follow the classes of the viewer

}  // namespace netloft::design
