// SPDX-License-Identifier: BSD-3-Clause
#include "io/variables/variable.hpp"

#include "io/units/units.hpp"

#include <algorithm>
#include <cassert>

namespace netloft::io {

bool Variable::is_number() const {
  return interval || (!values.empty() && std::all_of(values.begin(), values.end(),
                                                     [](const auto& v) { return v.number.has_value(); }));
}

VariableValue Variable::value_of(double number) const { return {format(number, unit), number}; }

std::vector<std::string> Variable::overrides(const VariableValue& value) const {
  std::vector<std::string> all;
  for (const FollowingKey& key : keys) {
    assert(key.follows_as_it_is() || value.number);
    const std::string text =
        key.follows_as_it_is() ? value.text : format(key.offset + key.factor * *value.number, unit);
    all.push_back(key.path + "=" + text);
  }
  return all;
}

std::map<std::string, Place> places_of_keys(const std::vector<Variable>& variables) {
  std::map<std::string, Place> places;
  for (const Variable& variable : variables)
    for (const FollowingKey& key : variable.keys) places.emplace(key.path, variable.place);
  return places;
}

}  // namespace netloft::io
