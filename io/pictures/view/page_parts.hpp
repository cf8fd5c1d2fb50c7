// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::pictures {

// The parts of a page that are the same for all results. CMakeLists.txt makes them from page/ and libraries/.
extern const char* const kPageLibraries;  // three.js and uPlot
extern const char* const kPageClasses;    // the scripts of page/ except the last one
extern const char* const kPageStart;      // the script that shows the results of a page
extern const char* const kPageStyle;
extern const char* const kPageBody;  // the elements of the viewer
// The Content-Security-Policy: only the two scripts and the style of the page, no network.
extern const char* const kPagePolicy;
extern const char* const kPageQuietPolicy;  // the policy of a page without scripts

}  // namespace netloft::pictures
