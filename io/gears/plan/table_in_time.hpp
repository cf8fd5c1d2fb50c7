// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"

#include <string>
#include <vector>

namespace netloft::gears {

/// Reads the column `t` of a table [s], whose times begin at zero and increase.
std::vector<double> read_times(formats::TableReader& table);
/// Reads the times of a table that replaces an earlier table from its first time on. A single time is enough.
std::vector<double> read_later_times(formats::TableReader& table);

/// Reads a column over the times. The column must begin with `start`; if it is missing, its value is `start`
/// at all times. `why` explains `start` in messages.
std::vector<double> read_column(formats::TableReader& table, const std::string& key,
                                const formats::RealsSpec& spec, double start, const std::string& why);

}  // namespace netloft::gears
