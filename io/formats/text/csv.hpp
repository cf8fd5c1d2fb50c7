// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace netloft::formats {

/// Returns a text as a cell of comma-separated values, quoted if necessary (RFC 4180), without control
/// characters except line feeds. A spreadsheet treats a text that begins with = + - or @ as a formula. Such a
/// text gets an apostrophe in front, unless it is a number (OWASP, "CSV Injection").
std::string csv_field(const std::string& text);

/// A number as a cell of comma-separated values; an empty cell if the number is not known (NaN).
std::string csv_number(double value);

}  // namespace netloft::formats
