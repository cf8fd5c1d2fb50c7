// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"

#include <string>
#include <vector>

namespace netloft::gears {

/// The column `t` of a table in time [s]: from zero on, each later than the one before.
std::vector<double> read_times(formats::TableReader& table);
/// The times of a table that replaces an earlier one at t[0]; one time is enough.
std::vector<double> read_later_times(formats::TableReader& table);

/// A column over the times. `start` is its value if it is missing, and its required first value.
std::vector<double> read_column(formats::TableReader& table, const std::string& key,
                                const formats::RealsSpec& spec, double start, const std::string& why);

}  // namespace netloft::gears
