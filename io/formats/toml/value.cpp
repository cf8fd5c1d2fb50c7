// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/value.hpp"

#include <bit>

namespace netloft::formats {

bool Table::operator==(const Table&) const = default;
bool Array::operator==(const Array&) const = default;

bool Value::operator==(const Value& other) const {
  if (place != other.place) return false;
  const double *mine = as<double>(), *its = other.as<double>();
  if (mine && its) return std::bit_cast<std::uint64_t>(*mine) == std::bit_cast<std::uint64_t>(*its);
  return data == other.data;
}

void shift_files(Value& value, int by) {
  const auto shift = [by](Place& place) { place.file += place.file >= 0 ? by : 0; };
  shift(value.place);
  if (Table* table = value.as<Table>())
    for (Member& member : table->members) {
      shift(member.place);
      shift_files(member.value, by);
    }
  if (Array* array = value.as<Array>())
    for (Value& item : array->items) shift_files(item, by);
}

}  // namespace netloft::formats
