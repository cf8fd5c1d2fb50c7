// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/scene_faults.hpp"

#include <string_view>

namespace netloft::studies {

void hand_on_faults(const formats::Diagnostics& of_scene, const std::map<std::string, formats::Place>& keys,
                    const formats::Place& scene, formats::Diagnostics& to) {
  constexpr std::string_view kSet = "--set ";
  for (const formats::Diagnostic& fault : of_scene.sorted()) {
    const std::string where = of_scene.where(fault.place);
    const auto key = where.starts_with(kSet) ? keys.find(where.substr(kSet.size())) : keys.end();
    const bool is_of_key = key != keys.end();
    const formats::Place& place = is_of_key ? key->second : scene;
    const std::string message = (is_of_key || where.empty() ? "" : where + ": ") + fault.message;
    fault.severity == formats::Severity::error ? to.error(place, message, fault.hint)
                                               : to.warning(place, message, fault.hint);
  }
}

}  // namespace netloft::studies
