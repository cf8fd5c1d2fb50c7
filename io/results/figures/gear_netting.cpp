// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of the netting: opening of the meshes, area and mass. Numbers in parentheses are equations of
// gear_figures.hpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "io/results/figures/gear_view.hpp"
#include "io/results/figures/materials.hpp"

namespace netloft::results {

namespace {

/// Sums over the modelled netting, which may be half of the net.
struct Amount {
  double area = 0, filtered = 0, twine_area = 0, mass = 0;
  bool is_spread = false;  // whether netting has triangles, so that areas are known

  void add(const Amount& other) {
    area += other.area;
    filtered += other.filtered;
    twine_area += other.twine_area;
    mass += other.mass;
    is_spread |= other.is_spread;
  }
};

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Adds the areas, (3) of gear_figures.hpp, of those triangles of a family (elements of one type) that belong
/// to panel `panel`.
void add_triangles(const GearView& gear, const ElementFamily& family, std::uint32_t panel, Amount& amount) {
  const auto [first, last] = family.elements_of(panel);
  for (std::size_t e = first; e < last; ++e) {
    const Vector a = gear.at(family.node(e, 0)), b = gear.at(family.node(e, 1)),
                 c = gear.at(family.node(e, 2));
    const Vector S = 0.5 * cross(b - a, c - a);
    amount.area += norm(S);
    amount.filtered += std::abs(dot(gear.current_at((1.0 / 3) * (a + b + c)), S));
    amount.is_spread = true;
  }
}

Amount amount_of(const GearView& gear, std::uint32_t panel) {
  Amount amount;
  amount.twine_area = sum(gear.output(panel, output::kTwineArea));
  amount.mass = sum(gear.output(panel, output::kMass));
  for (const auto& family : gear.assembler().families())
    if (family->type().element.stencil == NETLOFT_TRIANGLE && !family->repeated())
      add_triangles(gear, *family, panel, amount);
  return amount;
}

void add_amount(const GearView& gear, const std::string& at, const Amount& amount,
                std::vector<Figure>& figures) {
  const auto add = [&](const char* name, const char* unit, const char* doc, double value) {
    figures.push_back({at + name, unit, doc, gear.times() * value});
  };
  if (amount.is_spread) {
    add("area", "m2", "area of the netting as it is spread", amount.area);
    add("filtered_area", "m2", "projected area on the plane across the current", amount.filtered);
  }
  add(output::kTwineArea.name, output::kTwineArea.unit, "length times diameter of the twines, without knots",
      amount.twine_area);
  add(output::kMass.name, output::kMass.unit, "mass of the twines in air", amount.mass);
}

void add_opening(const GearView& gear, std::uint32_t panel, std::vector<Figure>& figures) {
  const auto angles = gear.output(panel, output::kHalfAngle), knots = gear.output(panel, output::kKnots);
  if (angles.empty() || angles.size() != knots.size()) return;
  double least = 1, most = 0, weighted = 0;
  for (std::size_t e = 0; e < angles.size(); ++e) {
    const double opening = std::sin(angles[e]);  // (2)
    least = std::min(least, opening);
    most = std::max(most, opening);
    weighted += knots[e] * opening;
  }
  const std::string at = "panels/" + gear.name(panel) + "/opening_",
                    doc = "width of a mesh over its stretched length, ";
  figures.push_back({at + "min", "1", doc + "where the netting is least open", least});
  figures.push_back({at + "mean", "1", doc + "mean over the meshes", weighted / sum(knots)});
  figures.push_back({at + "max", "1", doc + "where the netting is most open", most});
}

/// The row of the bill of materials to which a panel belongs; nullptr if there is none.
const scenes::BillItem* bill_of(const GearView& gear, std::uint32_t panel) {
  for (const auto& item : gear.gear().bill)
    if (item.kind == "netting" && is_called(gear.name(panel), item.name)) return &item;
  return nullptr;
}

/// The number of twines side by side in the bars of a panel.
double twines_of(const GearView& gear, const std::string& panel) {
  const auto sheet = std::ranges::find(gear.gear().netting, panel, &scenes::NettingSheet::name);
  return sheet == gear.gear().netting.end() ? 1 : sheet->twines;
}

void add_twine_tensions(const GearView& gear, std::uint32_t panel, std::vector<Figure>& figures) {
  const std::string at = "panels/" + gear.name(panel) + "/";
  const double largest = gear.largest_twine_tension(panel);
  if (!std::isfinite(largest)) return;
  figures.push_back({at + "tension_largest", "N", "largest tension of the twines of a bar", largest});
  const scenes::BillItem* item = bill_of(gear, panel);
  if (!item || !(item->diameter > 0)) return;
  const double section = twines_of(gear, item->name) * std::numbers::pi / 4 * item->diameter * item->diameter;
  figures.push_back({at + "stress_largest", "Pa",
                     "largest tension of the twines of a bar over the area of circles of their diameter",
                     largest / section});
}

}  // namespace

void add_netting_figures(const GearView& gear, std::vector<Figure>& figures) {
  Amount all;
  for (const auto panel : gear.gear().panels) {
    const Amount amount = amount_of(gear, panel);
    add_opening(gear, panel, figures);
    add_twine_tensions(gear, panel, figures);
    add_amount(gear, "panels/" + gear.name(panel) + "/", amount, figures);
    all.add(amount);
  }
  if (!gear.gear().panels.empty()) add_amount(gear, "netting/", all, figures);
}

}  // namespace netloft::results
