// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/merge.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>
#include <utility>

namespace netloft::formats {
namespace {

bool holds_tables_only(const Array& array) {
  return std::all_of(array.items.begin(), array.items.end(),
                     [](const Value& item) { return item.as<Table>(); });
}

void append(Array& base, Array over) {
  base.items.insert(base.items.end(), std::make_move_iterator(over.items.begin()),
                    std::make_move_iterator(over.items.end()));
}

void merge_tables(Table& base, Table over) {
  std::unordered_map<std::string, std::size_t>
      there;  // a linear search for every key would take quadratic time for long tables
  for (std::size_t i = 0; i < base.members.size(); ++i) there.emplace(base.members[i].key, i);
  for (Member& member : over.members) {
    if (const auto found = there.find(member.key); found != there.end()) {
      base.members[found->second].place = member.place;
      merge(base.members[found->second].value, std::move(member.value));
    } else {
      base.members.push_back(std::move(member));
    }
  }
}

}  // namespace

void merge(Value& base, Value over) {
  Table* tables[] = {base.as<Table>(), over.as<Table>()};
  Array* arrays[] = {base.as<Array>(), over.as<Array>()};
  if (tables[0] && tables[1]) {
    merge_tables(*tables[0], std::move(*tables[1]));
    base.place = over.place;
  } else if (arrays[0] && arrays[1] && arrays[1]->from_headers && holds_tables_only(*arrays[0])) {
    append(*arrays[0], std::move(*arrays[1]));
    arrays[0]->from_headers = true;
  } else {
    base = std::move(over);
  }
}

}  // namespace netloft::formats
