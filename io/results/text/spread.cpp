// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/spread.hpp"

#include "io/results/text/gear_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::results {

namespace {

bool has_spread(const NamedScalar& scalar) { return std::isfinite(scalar.least); }

std::string spread_row(const std::string& name, const NamedScalar& scalar) {
  return fmt::format("    {:<22} {:>14.6g} {:>14.6g} {:>14.6g} {}\n", name, scalar.value, scalar.least,
                     scalar.largest, scalar.unit == "1" ? "" : scalar.unit);
}

}  // namespace

std::string spread_text(const std::vector<NamedScalar>& scalars, const std::vector<NamedScalar>& gear) {
  std::string rows;
  for (const auto& scalar : scalars)
    if (has_spread(scalar)) rows += spread_row(scalar.name, scalar);
  for (const auto& figure : gear)
    if (const std::string name = principal_name(figure.name); has_spread(figure) && !name.empty())
      rows += spread_row(name, figure);
  if (rows.empty()) return rows;
  return fmt::format("  {:<24} {:>14} {:>14} {:>14}\n", "over all equilibria", "this one", "least",
                     "largest") +
         rows;
}

nlohmann::ordered_json spread_json(const std::vector<NamedScalar>& scalars) {
  nlohmann::ordered_json spread = nullptr;
  for (const auto& scalar : scalars)
    if (has_spread(scalar)) spread[scalar.name] = {{"least", scalar.least}, {"largest", scalar.largest}};
  return spread;
}

}  // namespace netloft::results
