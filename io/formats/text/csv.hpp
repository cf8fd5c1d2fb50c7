// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace netloft::formats {

/// A text as a cell of comma-separated values, quoted where it has to be (RFC 4180), without control
/// characters except line feeds. A text that a spreadsheet would take for a formula, because it begins with
/// = + - or @, gets an apostrophe before it (OWASP, "CSV Injection"); numbers are no formulas.
std::string csv_field(const std::string& text);

/// A number as a cell of comma-separated values; an empty cell if the number is not known (NaN).
std::string csv_number(double value);

}  // namespace netloft::formats
