// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/formats/units/udunits.hpp"

namespace netloft::formats {

/// The product of units in a text such as "kg/m3", "N.m/rad", "kg m-3", "kN/(m.s)", "mm^2", "1/m", or "" for
/// a pure number. The grammar:
///   product = [ "1" ] ["/"] factor { ["." | "*" | "/"] factor }    from left to right: kg/m.s = (kg/m).s
///   factor  = ( word | "(" product ")" ) [ ["^" | "**"] [sign] digit ]
/// Only single words are passed to the library UDUNITS, because the grammar of UDUNITS reads "10 5 m" as 50 m
/// and "3 s since 5" as a date, and leaks memory at every syntax error.
struct ParsedUnit {
  std::optional<Unit> unit;  // nullopt if the text cannot be read
  std::string unknown;       // the word that is not a unit; empty: an error of grammar
};

ParsedUnit parse_unit(const UnitSystem& system, std::string_view text);

}  // namespace netloft::formats
