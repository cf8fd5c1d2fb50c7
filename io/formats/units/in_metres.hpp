// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdio>
#include <string>

namespace netloft::formats {

/// Writes a length as "12.5 m", for a sentence.
inline std::string in_metres(double length, int digits = 4) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g m", digits, length);
  return text;
}

}  // namespace netloft::formats
