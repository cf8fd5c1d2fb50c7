// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/table_in_time.hpp"

#include <cmath>

namespace netloft::gears {

namespace {

const formats::Range kTimes{0, 1e9};

std::vector<double> read_ascending(formats::TableReader& table, std::size_t least) {
  const auto t = table.reals("t", {.unit = "s", .doc = "times", .range = kTimes, .count = {.least = least}});
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1])) {
      table.error("t", "does not ascend: each time must be later than the one before");
      break;
    }
  return t;
}

}  // namespace

std::vector<double> read_times(formats::TableReader& table) {
  auto t = read_ascending(table, 2);
  if (!t.empty() && t[0] != 0)
    table.error("t", "must begin at 0, the time until which the gear is towed steadily");
  return t;
}

std::vector<double> read_later_times(formats::TableReader& table) { return read_ascending(table, 1); }

std::vector<double> read_column(formats::TableReader& table, const std::string& key,
                                const formats::RealsSpec& spec, double start, const std::string& why) {
  if (!table.has(key)) return std::vector<double>(spec.count.least, start);
  auto column = table.reals(key, spec);
  if (!column.empty() && std::abs(column[0] - start) > 1e-9 * (1 + std::abs(start)))
    table.error(key, "begins with another value than " + why);
  column.resize(spec.count.least, start);
  return column;
}

}  // namespace netloft::gears
