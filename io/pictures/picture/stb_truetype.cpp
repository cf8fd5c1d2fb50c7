// SPDX-License-Identifier: BSD-3-Clause
//
// The one place that compiles the library, which is a header alone.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
