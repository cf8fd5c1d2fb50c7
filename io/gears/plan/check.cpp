// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"

#include "io/formats/work/long_work.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::gears {

void check_plan(NetPlan& plan, formats::Diagnostics& diagnostics, const CheckLimits& limits) {
  const formats::LongWork checking({"checking", "the net plan"});
  check_panels(plan, limits, diagnostics);
  const int errors_before = diagnostics.errors();
  check_joins(plan, limits, diagnostics);
  check_hangings(plan, limits, diagnostics);
  check_ropes(plan, limits, diagnostics);
  check_pieces(plan, limits, diagnostics);
  // After an error, such as an unknown name, parts may be unconnected for that reason alone.
  if (diagnostics.errors() == errors_before) check_connections(plan, diagnostics);
  if (diagnostics.errors() == 0) check_spans(plan, limits, diagnostics);
  if (diagnostics.errors() > 0) return;
  check_loose_ropes(plan, limits, diagnostics);
  check_open_edges(plan, diagnostics);
}

std::string in_meshes(double meshes) {
  const double tenths = std::round(10 * meshes) / 10;
  return fmt::format("{}", tenths == 0 ? 0.0 : tenths);
}

std::string in_metres(double metres) { return fmt::format("{:.4g}", metres); }

std::string in_percent(double fraction) { return fmt::format("{:+.1f} %", 100 * fraction); }

}  // namespace netloft::gears
