// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/studies/variables/variable.hpp"

namespace netloft::studies {

/// The values that a variable may have.
enum class VariedBy { values_or_interval, interval };

/// Reads one table of variables:
///   key    = "tow.speed", or several that go together, ["a.b", { key = "c.d[2]", factor = -1, offset = "2 m"
///   }] values = ["2.5 kn", "3 kn"]       listed: numbers, names of parts, switches, arrays range  = ["2 kn",
///   "4 kn"]         or an interval of numbers
/// Numbers have units of one dimension, or none, and then are what the key takes without one. Other keys of
/// the table are the caller's. What is wrong goes to the diagnostics; look at them before using the variable.
Variable read_variable(const std::string& name, formats::TableReader table,
                       VariedBy by = VariedBy::values_or_interval);

/// Reads a number of a variable, such as the mean of a distribution, in the variable's unit. Nothing if it is
/// missing or wrong, which is reported.
std::optional<double> read_number_of(const Variable& variable, formats::TableReader& table,
                                     const std::string& key, const std::string& doc);

}  // namespace netloft::studies
