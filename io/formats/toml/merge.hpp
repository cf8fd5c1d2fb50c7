// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/formats/toml/value.hpp"

#include <string>
#include <utility>

namespace netloft::formats {

/// Merges `over` into `base`: tables merge key by key, `[[hold]]` appends to an existing array of tables,
/// everything else replaces. Each value keeps the place where it was written.
void merge(Value& base, Value over);

/// Adds a key that the table does not have yet. The place of the key is that of its value.
inline void put(Table& table, const std::string& key, Value value) {
  const Place place = value.place;
  table.members.push_back({key, place, std::move(value)});
}

}  // namespace netloft::formats
