// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/inventory.hpp"

#include "io/formats/units/units.hpp"
#include "io/gears/drawing/plan_layout.hpp"
#include "io/gears/plan/check.hpp"

#include <limits>
#include <utility>

namespace netloft::scenes {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A number in the table of a part, converted to the SI unit `unit`; NaN if the table does not have it.
double number_of(const formats::Value& part, const char* key, const char* unit) {
  const formats::Table* table = part.as<formats::Table>();
  const formats::Member* member = table ? table->find(key) : nullptr;
  if (!member) return kNone;
  if (const double* value = member->value.as<double>()) return *value;
  if (const auto* value = member->value.as<std::int64_t>()) return static_cast<double>(*value);
  const std::string* text = member->value.as<std::string>();
  const formats::Quantity quantity = text ? formats::to_si(*text, unit) : formats::Quantity{kNone, "", ""};
  return quantity.ok() ? quantity.value : kNone;
}

double count_of(gears::Standing stands) { return stands == gears::Standing::pair ? 2 : 1; }

BillItem item_of(const gears::Panel& panel) {
  return {"netting",
          panel.name,
          panel.twine_name,
          count_of(panel.stands),
          kNone,
          panel.twine_diameter,
          number_of(panel.twine, "breaking_load", "N") * panel.twines,
          kNone,
          kNone};
}

BillItem item_of(const gears::Rope& rope) {
  return {"rope",
          rope.name,
          rope.part_name,
          count_of(rope.stands),
          rope.length,
          number_of(rope.rope, "diameter", "m"),
          number_of(rope.rope, "breaking_load", "N"),
          kNone,
          kNone};
}

BillItem item_of(const gears::Pieces& pieces) {
  return {"piece",
          pieces.name,
          pieces.part_name,
          pieces.number,
          kNone,
          number_of(pieces.piece, "diameter", "m"),
          kNone,
          number_of(pieces.piece, "mass", "kg"),
          kNone};
}

/// The cuttings of one side, from fore to aft.
std::string spelled(const std::vector<gears::Cut>& side) {
  std::string text;
  for (const auto& cut : side)
    text += (text.empty() ? "" : ", ") + cut.written +
            (cut.goes > 0   ? " out "
             : cut.goes < 0 ? " in "
                            : " ") +
            gears::in_meshes(cut.deep);
  return text;
}

NettingSheet sheet_of(const gears::Panel& panel) {
  return {.name = panel.name,
          .number = count_of(panel.stands),
          .mesh = panel.mesh,
          .twine = panel.twine_name,
          .twines = static_cast<double>(panel.twines),
          .laid = panel.orientation,
          .fore = panel.count(panel.fore),
          .aft = panel.count(panel.aft),
          .deep = panel.depth,
          .pieces = static_cast<double>(panel.pieces),
          .outer = spelled(panel.outer),
          .inner = spelled(panel.inner)};
}

SheetPlace place_of(const gears::PlacedPanel& placed) {
  const gears::PanelPoint origin = placed.on_sheet({0, 0}), across = placed.on_sheet({1, 0}),
                          deep = placed.on_sheet({0, 1});
  return {origin.x, origin.y, across.x - origin.x, across.y - origin.y, deep.x - origin.x, deep.y - origin.y};
}

}  // namespace

double breaking_load_of(const formats::Value& numbers) { return number_of(numbers, "breaking_load", "N"); }

std::vector<BillItem> bill_of(const gears::NetPlan& plan) {
  std::vector<BillItem> bill;
  for (const auto& panel : plan.panels) bill.push_back(item_of(panel));
  for (const auto& rope : plan.ropes)
    if (!rope.is_selvedge) bill.push_back(item_of(rope));
  for (const auto& pieces : plan.pieces) bill.push_back(item_of(pieces));
  return bill;
}

std::vector<NettingSheet> netting_of(const gears::NetPlan& plan) {
  std::vector<NettingSheet> netting;
  for (const auto& panel : plan.panels)
    if (!panel.has_corners) netting.push_back(sheet_of(panel));
  return netting;
}

std::map<std::string, SheetPlace> sheet_of(const gears::NetPlan& plan, const gears::Gear& gear) {
  std::map<std::pair<const gears::Panel*, bool>, SheetPlace> places;
  for (const auto& placed : gears::lay_out(plan))
    places.try_emplace({placed.panel, placed.is_mirrored}, place_of(placed));
  std::map<std::string, SheetPlace> sheet;
  for (const auto& panel : gear.panels)
    if (const auto at = places.find({panel.panel, panel.is_mirrored}); at != places.end())
      sheet[panel.name] = at->second;
  return sheet;
}

}  // namespace netloft::scenes
