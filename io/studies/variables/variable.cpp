// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/variable.hpp"

#include "io/formats/units/units.hpp"

#include <algorithm>
#include <cassert>

namespace netloft::studies {

bool is_variable_name(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::optional<double> number_in_unit(const std::string& text, const std::string& unit) {
  const formats::WrittenQuantity written = formats::read_as_written(text);
  if (!written.ok() || written.unit.empty() != unit.empty()) return std::nullopt;
  if (written.unit == unit) return written.number;
  const formats::Quantity converted = formats::to_si(text, unit);
  return converted.ok() ? std::optional(converted.value) : std::nullopt;
}

bool Variable::is_number() const {
  return interval || (!values.empty() && std::all_of(values.begin(), values.end(),
                                                     [](const auto& v) { return v.number.has_value(); }));
}

VariableValue Variable::value_of(double number) const { return {formats::format(number, unit), number}; }

std::vector<std::string> Variable::overrides(const VariableValue& value) const {
  std::vector<std::string> all;
  for (const FollowingKey& key : keys) {
    assert(key.follows_as_it_is() || value.number);
    const std::string text =
        key.follows_as_it_is() ? value.text : formats::format(key.offset + key.factor * *value.number, unit);
    all.push_back(key.path + "=" + text);
  }
  return all;
}

}  // namespace netloft::studies
