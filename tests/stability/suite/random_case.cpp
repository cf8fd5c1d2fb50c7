// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/random_case.hpp"

#include "io/formats/units/units.hpp"

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;

namespace {

std::string random_number(TableReader& entry, scenes::Dice& dice) {
  const bool log = entry.boolean("log", {.doc = "uniform in its logarithm", .fallback = false});
  const double from = entry.real("from", {.doc = "least value", .range = log ? above(0) : Range{}});
  const double to = entry.real("to", {.doc = "largest value", .range = at_least(from)});
  return formats::format(log ? dice.log_uniform(from, to) : dice.uniform(from, to));
}

std::string random_text(TableReader& entry, scenes::Dice& dice) {
  if (entry.has("one_of")) {
    const auto words = entry.texts("one_of", {.doc = "texts to choose from", .count = {.least = 1}});
    return words.empty() ? "" : words[dice.index(words.size())];
  }
  if (!entry.has("whole")) return random_number(entry, dice);
  const auto ends = entry.integers("whole", {.doc = "least and largest number", .count = exactly(2)});
  if (ends.size() != 2 || ends[0] > ends[1]) return "0";
  return std::to_string(dice.whole(ends[0], ends[1]));
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

RandomTexts random_texts(TableReader vary, scenes::Dice& dice) {
  RandomTexts random;
  for (const auto& name : vary.keys()) {
    TableReader entry = vary.table(name);
    random[name] = random_text(entry, dice);
  }
  return random;
}

void fill_in(formats::Value& value, const RandomTexts& random) {
  if (auto* text = value.as<std::string>()) {
    // From the last name to the first, so that $across_aft is not taken for $across.
    for (auto d = random.rbegin(); d != random.rend(); ++d) replace_all(*text, "$" + d->first, d->second);
  }
  if (auto* array = value.as<Array>())
    for (auto& item : array->items) fill_in(item, random);
  if (auto* table = value.as<Table>())
    for (auto& member : table->members) fill_in(member.value, random);
}

}  // namespace netloft::hard_cases
