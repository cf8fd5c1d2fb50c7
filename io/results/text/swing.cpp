// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/swing.hpp"

#include "io/results/text/gear_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace netloft::results {

namespace {

bool is_known(const NamedScalar& scalar) { return std::isfinite(scalar.per_swing); }

std::string swing_row(const std::string& name, const NamedScalar& scalar) {
  return fmt::format("    {:<22} {:>14.6g} {:>14.2g} {}\n", name, scalar.value, scalar.per_swing,
                     scalar.unit == "1" ? "" : scalar.unit);
}

}  // namespace

std::string swing_text(const std::string& furthest, const std::vector<NamedScalar>& scalars,
                       const std::vector<NamedScalar>& gear) {
  std::string rows;
  for (const auto& scalar : scalars)
    if (is_known(scalar)) rows += swing_row(scalar.name, scalar);
  for (const auto& figure : gear)
    if (const std::string name = principal_name(figure.name); is_known(figure) && !name.empty())
      rows += swing_row(name, figure);
  if (rows.empty()) return rows;
  return fmt::format("  {:<24} {:>14} {:>14}   for each metre that {} moves, to first order\n",
                     "what depends on it", "here", "changes by", furthest) +
         rows;
}

nlohmann::ordered_json swing_json(const RunResult& result) {
  nlohmann::ordered_json per_metre = nlohmann::ordered_json::object();
  for (const auto* scalars : {&result.scalars, &result.gear})
    for (const auto& scalar : *scalars)
      if (is_known(scalar)) per_metre[scalar.name] = scalar.per_swing;
  if (result.swings_most.empty()) return nullptr;
  const Solution& s = result.solution;
  const auto time = [](double of, double rate) {
    return rate > 0 ? nlohmann::ordered_json(of / rate) : nlohmann::ordered_json(nullptr);
  };
  return {{"furthest", result.swings_most},
          {"tenfold_in", time(std::log(10), s.growing.rate)},
          {"period", time(2 * std::numbers::pi, flutters(s) ? s.growing.frequency : 0)},
          {"per_metre", per_metre}};
}

}  // namespace netloft::results
