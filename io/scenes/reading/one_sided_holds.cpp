// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/one_sided_holds.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

std::string mirrored_word(const std::string& word) {
  constexpr std::string_view kPort = "port", kStarboard = "starboard";
  const auto begins_with = [&](std::string_view side) {
    return word.starts_with(side) && (word.size() == side.size() || word[side.size()] == '-');
  };
  if (begins_with(kPort)) return std::string(kStarboard) + word.substr(kPort.size());
  if (begins_with(kStarboard)) return std::string(kPort) + word.substr(kStarboard.size());
  return word;
}

/// Whether the scene has a point, a part, or an edge with this name.
bool has(const Draft& draft, const std::string& name) {
  if (draft.points.contains(name)) return true;
  const auto dot = name.find('.');
  const auto part = draft.part_number(name.substr(0, dot));
  return part &&
         (dot == std::string::npos || draft.geometries[*part].names.sets.contains(name.substr(dot + 1)));
}

/// Replaces ".end" of a rope that runs from port to starboard by ".starboard", another name of the same end.
std::string in_full(const Draft& draft, const std::string& name) {
  const std::string port = name.substr(0, name.find('.')) + ".port";
  return name.ends_with(".end") && has(draft, port) ? name.substr(0, name.find('.')) + ".starboard" : name;
}

}  // namespace

std::string mirror_image(const std::string& name) {
  const auto dot = name.find('.');
  if (dot == std::string::npos) return mirrored_word(name);
  return mirrored_word(name.substr(0, dot)) + "." + mirrored_word(name.substr(dot + 1));
}

void OneSidedHolds::report(Draft& draft, formats::Diagnostics& diagnostics) const {
  for (const auto& held : holds_) {
    const std::string other = mirror_image(in_full(draft, held.on));
    if (other == in_full(draft, held.on) || !has(draft, other)) continue;
    const auto set = draft.find_nodes({other, held.place, "hold"});
    if (!set) continue;
    const auto nodes = draft.scene_nodes(*set);
    if (std::all_of(nodes.begin(), nodes.end(),
                    [&](auto node) { return (draft.out.scene.held[node] & held.axes) == held.axes; }))
      continue;
    diagnostics.warning(held.place,
                        "\"" + held.on + "\" is held, and \"" + other + "\" on the other side is not",
                        "the gear is the same on both sides: hold both, or it hangs askew");
  }
}

}  // namespace netloft::scenes
