// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/studies/variables/variable.hpp"

namespace netloft::studies {

/// Whether a variable may have listed values or an interval, or only an interval.
enum class VariedBy { values_or_interval, interval };

/// Reads one variable from its table:
///   key    = "tow.speed"            or several keys that change together,
///            ["a.b", {key = "c.d[2]", factor = -1, offset = "2 m"}]
///   values = ["2.5 kn", "3 kn"]     listed: numbers, names of parts, switches, arrays
///   range  = ["2 kn", "4 kn"]       or an interval of numbers
/// Either all numbers have units of one dimension, or none has a unit and all are in the default unit of the
/// key. The caller reads other keys of the table. Errors are reported to the diagnostics of the table; after
/// an error, the variable must not be used.
Variable read_variable(const std::string& name, formats::TableReader table,
                       VariedBy by = VariedBy::values_or_interval);

/// Reads a number such as the mean of a distribution, in the unit of the variable. If the number is missing
/// or wrong, reports an error and returns nullopt.
std::optional<double> read_number_of(const Variable& variable, formats::TableReader& table,
                                     const std::string& key, const std::string& doc);

}  // namespace netloft::studies
