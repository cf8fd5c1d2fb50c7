// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::formats {

/// Units that are common in scenes, catalogues and the tables of plugins. Error messages propose them instead
/// of an unknown unit. The program knows them without reading the database of UDUNITS.
inline constexpr const char* kCommonWords[] = {
    "m",     "mm",      "cm",     "km",       "um",     "in",   "ft",     "fathom", "nmi",    "nautical_mile",
    "kg",    "g",       "t",      "tonne",    "lb",     "N",    "kN",     "MN",     "daN",    "kgf",
    "tonf",  "lbf",     "Pa",     "kPa",      "MPa",    "GPa",  "bar",    "s",      "min",    "h",
    "hour",  "day",     "kn",     "kt",       "knot",   "deg",  "degree", "rad",    "radian", "rpm",
    "Hz",    "J",       "W",      "kW",       "tex",    "Rtex", "denier", "K",      "degC",   "%",
    "metre", "meter",   "newton", "kilogram", "second", "foot", "inch",   "pound",  "pascal", "minute",
    "knots", "fathoms", "percent"};

}  // namespace netloft::formats
