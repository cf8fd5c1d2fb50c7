// SPDX-License-Identifier: BSD-3-Clause
//
// Compiles the library stb_truetype, which consists of a single header; no other file compiles it.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
