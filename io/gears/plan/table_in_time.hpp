// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"

#include <string>
#include <vector>

namespace netloft::gears {

/// Reads the column `t` of a table [s], whose times begin at zero and increase.
std::vector<double> read_times(formats::TableReader& table);
/// Reads the times of a table that replaces an earlier table at t[0]; a single time is enough.
std::vector<double> read_later_times(formats::TableReader& table);

/// Reads a column over the times. It must begin with `start`, which is also its value if the column is
/// missing; `why` explains this value in messages.
std::vector<double> read_column(formats::TableReader& table, const std::string& key,
                                const formats::RealsSpec& spec, double start, const std::string& why);

}  // namespace netloft::gears
