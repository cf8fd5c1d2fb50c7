// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

namespace netloft::scenes {

/// Converts a text to capitals, because MoorDyn ignores the case of its words.
std::string in_capitals(std::string_view text);

/// Sections of an input file of MoorDyn.
enum class MoordynSection {
  none,
  line_types,
  rod_types,
  bodies,
  rods,
  points,
  lines,
  options,
  outputs,
  other
};

/// The section whose name is at the beginning of `title`, which is in capitals.
MoordynSection section_named(const std::string& title);

/// The effect of an option in MoorDyn if a scene cannot represent this option; otherwise nullopt. `name` is
/// in capitals.
std::optional<std::string> meaning_of_option(const std::string& name);

/// Whether an option selects waves or currents; `name` is in capitals.
bool is_option_of_water(const std::string& name);

/// The end of a line whose tension is an output of MoorDyn: FairTen3 and Line3TenB are for the end of line 3,
/// AnchTen3 and Line3TenA for its start.
struct EndTension {
  std::string line;
  bool is_at_start = false;
};
std::optional<EndTension> end_tension_named(const std::string& name);

}  // namespace netloft::scenes
