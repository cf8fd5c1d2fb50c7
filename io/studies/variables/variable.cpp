// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/variable.hpp"

#include "io/formats/units/units.hpp"

#include <algorithm>
#include <cassert>

namespace netloft::studies {

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
