// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/draw.hpp"

#include "io/formats/units/units.hpp"

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;
using namespace runs;

namespace {

std::string draw_number(TableReader& entry, scenes::Dice& dice) {
  const bool log = entry.boolean("log", {.doc = "uniform in its logarithm", .fallback = false});
  const double from = entry.real("from", {.doc = "least value", .range = log ? above(0) : Range{}});
  const double to = entry.real("to", {.doc = "largest value", .range = at_least(from)});
  return formats::format(log ? dice.log_uniform(from, to) : dice.uniform(from, to));
}

std::string draw_one(TableReader& entry, scenes::Dice& dice) {
  if (entry.has("one_of")) {
    const auto words = entry.texts("one_of", {.doc = "texts to choose from", .count = {.least = 1}});
    return words.empty() ? "" : words[dice.index(words.size())];
  }
  if (!entry.has("whole")) return draw_number(entry, dice);
  const auto ends = entry.integers("whole", {.doc = "least and largest number", .count = exactly(2)});
  if (ends.size() != 2 || ends[0] > ends[1]) return "0";
  return std::to_string(dice.whole(ends[0], ends[1]));
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

Drawn draw(TableReader vary, scenes::Dice& dice) {
  Drawn drawn;
  for (const auto& name : vary.keys()) {
    TableReader entry = vary.table(name);
    drawn[name] = draw_one(entry, dice);
  }
  return drawn;
}

void fill_in(formats::Value& value, const Drawn& drawn) {
  if (auto* text = value.as<std::string>()) {
    // From behind, so that $across_aft is not taken for $across.
    for (auto d = drawn.rbegin(); d != drawn.rend(); ++d) replace_all(*text, "$" + d->first, d->second);
  }
  if (auto* array = value.as<Array>())
    for (auto& item : array->items) fill_in(item, drawn);
  if (auto* table = value.as<Table>())
    for (auto& member : table->members) fill_in(member.value, drawn);
}

}  // namespace netloft::hard_cases
