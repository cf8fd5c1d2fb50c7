// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"

#include "io/formats/toml/table_reader.hpp"
#include "io/formats/work/long_work.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::gears {

namespace {

void check_twine(const Panel& panel, formats::Diagnostics& diagnostics) {
  if (panel.twine_diameter * panel.twines * 2 >= panel.mesh && panel.mesh > 0)
    diagnostics.error(panel.place,
                      fmt::format("{}: {} twines of {:.3g} mm leave no opening in meshes of {:.4g} mm",
                                  panel.name, panel.twines, 1e3 * panel.twine_diameter, 1e3 * panel.mesh),
                      "mesh is the stretched mesh size: two bars");
}

void check_thickness(const Rope& rope, formats::Diagnostics& diagnostics) {
  const formats::Table* numbers = rope.rope.as<formats::Table>();
  const formats::Member* diameter = numbers ? numbers->find("diameter") : nullptr;
  if (!diameter || rope.is_selvedge) return;
  formats::Diagnostics silent;
  const double thick = formats::TableReader(rope.rope, silent)
                           .real("diameter", {.unit = "m", .range = formats::between(0, 1e6)});
  if (silent.errors() == 0 && thick >= rope.length)
    diagnostics.error(rope.place,
                      fmt::format("{} is {} m thick and only {} m long", rope.name, in_metres(thick),
                                  in_metres(rope.length)),
                      "one of the two may be in another unit");
}

}  // namespace

void check_net(NetPlan& plan, formats::Diagnostics& diagnostics, const CheckLimits& limits) {
  const formats::LongWork checking({"checking", "the net plan"});
  check_panels(plan, limits, diagnostics);
  const int errors_before = diagnostics.errors();
  check_joins(plan, limits, diagnostics);
  check_hangings(plan, limits, diagnostics);
  check_rims(plan, diagnostics);
  check_ropes(plan, limits, diagnostics);
  // Connections are not checked after an error, because the error itself may be why parts are unconnected:
  // for example, an unknown name.
  if (diagnostics.errors() == errors_before) check_connections(plan, diagnostics);
  if (diagnostics.errors() == 0) check_loops(plan, diagnostics);
  if (diagnostics.errors() > 0) return;
  check_loose_ropes(plan, limits, diagnostics);
  check_open_edges(plan, diagnostics);
}

void check_plan(NetPlan& plan, formats::Diagnostics& diagnostics, const CheckLimits& limits) {
  check_net(plan, diagnostics, limits);
  check_fittings(plan, diagnostics.errors() ? std::vector<RopeSpan>{} : rope_spans(plan), diagnostics,
                 limits);
}

void check_fittings(const NetPlan& plan, const std::vector<RopeSpan>& spans,
                    formats::Diagnostics& diagnostics, const CheckLimits& limits) {
  for (const auto& panel : plan.panels) check_twine(panel, diagnostics);
  for (const auto& rope : plan.ropes) check_thickness(rope, diagnostics);
  check_pieces(plan, limits, diagnostics);
  if (diagnostics.errors() == 0) check_spans(plan, spans, limits, diagnostics);
}

std::string in_meshes(double meshes) {
  const double tenths = std::round(10 * meshes) / 10;
  return fmt::format("{}", tenths == 0 ? 0.0 : tenths);
}

std::string in_metres(double metres) { return fmt::format("{:.4g}", metres); }

std::string in_percent(double fraction) { return fmt::format("{:+.1f} %", 100 * fraction); }

}  // namespace netloft::gears
