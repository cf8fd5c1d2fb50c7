// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/gear_size.hpp"

#include "io/gears/meshing/cloths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace netloft::gears {

namespace {

double area_of(const Gear& gear, const Fineness& fineness) {
  double area = 0;
  for (const auto& panel : gear.panels)
    for (const auto& edge : panel.outline.edges) {
      const PanelPoint a = spread(*panel.panel, edge.from), b = spread(*panel.panel, edge.to);
      area += std::pow(finer(fineness, panel), 2) * (a.x * b.y - b.x * a.y) / 2;
    }
  return area;
}

/// Total length [m] of all ropes except warps. The bars of warps have a length of their own.
double length_of(const Gear& gear) {
  double length = 0;
  for (const auto& rope : gear.ropes)
    if (rope.rope->role != kWarp) length += rope.length;
  return length;
}

/// Approximate number of knots: two per mesh.
double knots_of(const Gear& gear) {
  double knots = 0;
  for (const auto& panel : gear.panels)
    for (const auto& edge : panel.outline.edges) knots += edge.from.x * edge.to.y - edge.to.x * edge.from.y;
  return std::abs(knots);
}

}  // namespace

double finer(const Fineness& fineness, const GearPanel& panel) {
  for (const auto& name : {panel.name, panel.panel->name})
    if (const auto at = fineness.finer.find(name); at != fineness.finer.end()) return at->second;
  return 1;
}

double size_for(const Gear& gear, const Fineness& fineness) {
  const double n = static_cast<double>(std::max<std::size_t>(fineness.nodes, 3));
  const double a = 1.2 * 2 / std::numbers::sqrt3 * area_of(gear, fineness), l = length_of(gear);
  return (l + std::sqrt(l * l + 4 * n * a)) / (2 * n);
}

double shortest_bar(const Gear& gear) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& panel : gear.panels) shortest = std::min(shortest, panel.panel->mesh / 2);
  return shortest;
}

void check_knots(const Gear& gear) {
  if (const double knots = knots_of(gear); knots > kMostNodes)
    throw std::invalid_argument(fmt::format(
        "the netting has {:.3g} knots, but a mesh can have at most {:g} nodes", knots, kMostNodes));
}

void check_size(const Gear& gear, const Fineness& fineness) {
  const double netting = area_of(gear, fineness) / std::pow(fineness.size, 2);
  if (netting + length_of(gear) / fineness.size > kMostNodes)
    throw std::invalid_argument(
        fmt::format("elements of {:g} m would have more than {:g} nodes", fineness.size, kMostNodes));
}

}  // namespace netloft::gears
