// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"

#include <string>
#include <vector>

namespace netloft::gears {

/// The column `t` of a table in time [s]: from zero on, each later than the one before.
std::vector<double> read_times(formats::TableReader& table);
/// The same of a table that goes on at t[0] from what was there until then; one time may do.
std::vector<double> read_later_times(formats::TableReader& table);

/// A column beside the times; `start` where it is left out, and what it has to begin with.
std::vector<double> read_column(formats::TableReader& table, const std::string& key,
                                const formats::RealsSpec& spec, double start, const std::string& why);

}  // namespace netloft::gears
