// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/outline.hpp"
#include "io/gears/plan/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace netloft::gears {

namespace {

constexpr const char* kRates =
    "rates are written AB, AN, 5B1P, 1N2B, 3B1M: bars, then points or meshes, of one cycle";

/// The relative difference between two numbers of meshes at the aft edge: the number that follows from the
/// cuttings, and the count in the plan. Zero if the plan states no count.
double misses_by(const Panel& panel) {
  const double aft = panel.count(panel.aft);
  return panel.states_aft ? std::abs(aft_by_cuttings(panel) - aft) / std::max(1.0, aft) : 0;
}

/// A copy of the panel in which one cut has another rate.
Panel with_rate(Panel panel, bool is_outer, std::size_t which, const std::string& rate) {
  auto& side = is_outer ? panel.outer : panel.inner;
  side[which].written = rate;
  side[which].rate = *parse_rate(rate);
  side[which].is_known = true;
  settle(side, panel.depth);
  panel.outline = outline_of(panel);
  return panel;
}

/// Considers all rates that differ from the written text in one letter, and returns the one for which the aft
/// edge agrees best with the count in the plan; an empty text if there is no such rate.
std::string propose_rate(const Panel& panel, bool is_outer, std::size_t which) {
  const Cut& cut = (is_outer ? panel.outer : panel.inner)[which];
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& rate : rates_near(cut.written)) {
    const double miss = misses_by(with_rate(panel, is_outer, which, rate));
    if (miss < least) {
      best = rate;
      least = miss;
    }
  }
  return best;
}

/// Reports a text that is not a rate. `mended` is the panel with the proposed rate, if a rate is proposed.
void say_no_rate(const Panel& panel, bool is_outer, std::size_t which, const std::string& proposed,
                 const Panel& mended, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const Cut& cut = (is_outer ? panel.outer : panel.inner)[which];
  const Cut& meant = (is_outer ? mended.outer : mended.inner)[which];
  const std::string said =
      fmt::format("{}.{}: cutting \"{}\" is not a rate", panel.name, cut.name, cut.written);
  if (proposed.empty()) return diagnostics.error(cut.place, said, kRates);
  const bool fits = misses_by(mended) <= limits.closing_error;
  diagnostics.error(cut.place,
                    fmt::format("{}; {}, {} M over {} M, {}", said, proposed, in_meshes(meant.across),
                                in_meshes(meant.deep), fits ? "fits" : "comes nearest"),
                    kRates, cures_of_rate(panel, is_outer, which, {proposed}));
}

void mend_side(Panel& panel, bool is_outer, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const auto side = is_outer ? panel.outer : panel.inner;
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side[i].is_known) continue;
    const std::string proposed = propose_rate(panel, is_outer, i);
    const Panel mended = proposed.empty() ? panel : with_rate(panel, is_outer, i, proposed);
    say_no_rate(panel, is_outer, i, proposed, mended, limits, diagnostics);
    panel = mended;
  }
}

bool all_rates_are_known(const Panel& panel) {
  const auto known = [](const Cut& cut) { return cut.is_known; };
  return std::all_of(panel.outer.begin(), panel.outer.end(), known) &&
         std::all_of(panel.inner.begin(), panel.inner.end(), known);
}

void check_closing(const Panel& panel, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const double cut = aft_by_cuttings(panel), planned = panel.count(panel.aft), difference = cut - planned;
  const auto wanted = [&](const auto& cures) { return diagnostics.wants_cures() ? cures() : Cures{}; };
  const auto closing = [&] { return cures_of_closing(panel, limits); };
  if (cut < -limits.closing_meshes)
    return diagnostics.error(
        panel.place,
        fmt::format("{}: its sides meet before the aft edge: the cuttings give {} meshes there", panel.name,
                    in_meshes(cut)),
        "let one of the sides go out instead of in, or shorten a cut",
        panel.states_aft ? wanted(closing) : wanted([&] { return cures_of_direction(panel); }));
  if (!panel.states_aft || std::abs(difference) <= limits.closing_meshes) return;
  const double fraction = difference / std::max(1.0, planned);
  const std::string message =
      fmt::format("{}.aft: the cuttings give {} meshes, but the plan says {}, {}", panel.name, in_meshes(cut),
                  in_meshes(planned), in_percent(fraction));
  if (std::abs(fraction) > limits.closing_error)
    diagnostics.error(panel.aft_place, message, "", wanted(closing));
  else
    diagnostics.warning(panel.aft_place, message, "", wanted(closing));
}

void check_depth(const Panel& panel, const std::vector<Cut>& side, const char* name,
                 const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  double deep = 0;
  for (const auto& cut : side) deep += cut.deep;
  const double difference = deep - panel.depth;
  if (side.empty() || std::abs(difference) <= limits.closing_meshes) return;
  const std::string message =
      fmt::format("{}.{}: its cuttings go {} meshes deep, but the panel {}, {}", panel.name, name,
                  in_meshes(deep), in_meshes(panel.depth), in_percent(difference / panel.depth));
  const std::string cure = "leave out the depth of one of its cuts, which then takes the rest";
  const Cures cures = diagnostics.wants_cures() ? cures_of_depth(panel, side, name) : Cures{};
  if (std::abs(difference) > limits.closing_error * panel.depth)
    diagnostics.error(side.front().place, message, cure, cures);
  else
    diagnostics.warning(side.front().place, message, cure, cures);
}

void check_empty(const Panel& panel, formats::Diagnostics& diagnostics) {
  if (panel.is_empty())
    diagnostics.error(panel.place, panel.name + ": has meshes neither along its fore nor along its aft edge");
}

void check_edge_names(const Panel& panel, formats::Diagnostics& diagnostics) {
  std::set<std::string> seen;
  const auto check = [&](const std::string& name, const formats::Place& place) {
    if (!seen.insert(name).second)
      diagnostics.error(place, fmt::format("{}: two of its edges are named \"{}\"", panel.name, name));
  };
  for (const auto* counts : {&panel.fore, &panel.aft})
    for (const auto& count : *counts) check(count.name, count.place);
  for (const auto* side : {&panel.outer, &panel.inner})
    for (const auto& cut : *side) check(cut.name, cut.place);
}

/// Reports seams that gather all meshes of a panel. In the remaining checks, these seams gather none.
void check_selvedges(Panel& panel, formats::Diagnostics& diagnostics) {
  double gathered = 0;
  for (const auto* side : {&panel.outer, &panel.inner}) {
    double most = 0;
    for (const auto& cut : *side) most = std::max(most, cut.selvedge);
    gathered += (panel.stands == Standing::middle ? 2 : 1) * most;
  }
  const double widest = std::max(panel.count(panel.fore), panel.count(panel.aft));
  if (gathered == 0 || gathered < widest) return;
  diagnostics.error(panel.place,
                    fmt::format("{}: its seams gather {} meshes of {}: no netting is left between them",
                                panel.name, in_meshes(gathered), in_meshes(widest)),
                    "selvedge counts the meshes of one edge");
  for (auto* side : {&panel.outer, &panel.inner})
    for (auto& cut : *side) cut.selvedge = 0;
  panel.outline = outline_of(panel);
}

/// The corners of one side of an outline from fore to aft.
std::vector<PanelPoint> side_of(const Outline& outline, bool is_outer) {
  std::vector<PanelPoint> corners;
  for (const auto& edge : outline.edges)
    if (edge.kind == EdgeKind::outer
            ? is_outer
            : !is_outer && edge.kind != EdgeKind::fore && edge.kind != EdgeKind::aft) {
      if (corners.empty()) corners.push_back(edge.from);
      corners.push_back(edge.to);
    }
  if (!is_outer) std::reverse(corners.begin(), corners.end());
  return corners;
}

/// The innermost x of the outer side, or the outermost x of the inner side, at the depth `y`.
double place_at(const std::vector<PanelPoint>& side, double y, bool is_outer) {
  const double none = (is_outer ? 1 : -1) * std::numeric_limits<double>::infinity();
  double most = none;
  for (std::size_t k = 0; k + 1 < side.size(); ++k) {
    const PanelPoint &a = side[k], &b = side[k + 1];
    if (y < a.y || y > b.y) continue;
    const double t = b.y > a.y ? (y - a.y) / (b.y - a.y) : 0, x = a.x + t * (b.x - a.x);
    for (const double at : {x, b.y > a.y ? x : b.x})
      most = is_outer ? std::min(most, at) : std::max(most, at);
  }
  return most;
}

/// Refuses a panel whose sides meet or cross between its fore and its aft edge.
void check_width(const Panel& panel, formats::Diagnostics& diagnostics) {
  constexpr double kNone = 1e-9;  // [meshes]
  const Outline& outline = panel.outline;
  const auto outer = side_of(outline, true), inner = side_of(outline, false);
  for (const auto* side : {&outer, &inner})
    for (const auto& corner : *side) {
      if (corner.y < kNone || corner.y > panel.depth - kNone) continue;
      if (place_at(outer, corner.y, true) - place_at(inner, corner.y, false) > kNone) continue;
      return diagnostics.error(
          panel.place,
          fmt::format("{}: its sides meet {} meshes aft of its fore end: no netting is left between them",
                      panel.name, in_meshes(corner.y)),
          "shorten a cut, let one of the sides go out instead of in, or divide the panel there",
          diagnostics.wants_cures() ? cures_of_direction(panel) : Cures{});
    }
}

}  // namespace

void check_panels(NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  for (auto& panel : plan.panels) {
    const int errors_before = diagnostics.errors();
    mend_side(panel, true, limits, diagnostics);
    mend_side(panel, false, limits, diagnostics);
    check_edge_names(panel, diagnostics);
    check_empty(panel, diagnostics);
    check_selvedges(panel, diagnostics);
    if (!all_rates_are_known(panel)) continue;
    check_depth(panel, panel.outer, panel.stands == Standing::middle ? "sides" : "outer", limits,
                diagnostics);
    check_depth(panel, panel.inner, "inner", limits, diagnostics);
    check_closing(panel, limits, diagnostics);
    if (diagnostics.errors() == errors_before) check_width(panel, diagnostics);
  }
}

}  // namespace netloft::gears
