// SPDX-License-Identifier: BSD-3-Clause
//
// Compiles the library, which consists of a header only. No other file does.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
