// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

namespace netloft::scenes {

/// Words of MoorDyn are compared in capitals.
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

/// The section that a title in capitals begins.
MoordynSection section_named(const std::string& title);

/// The effect in MoorDyn of an option that a scene cannot represent; nothing for an unknown option. `name` is
/// in capitals.
std::optional<std::string> meaning_of_option(const std::string& name);

/// Whether an option, in capitals, selects waves or currents.
bool is_option_of_water(const std::string& name);

/// The line at whose end an output is the tension, and which end: FairTen3, Line3TenB, AnchTen3, Line3TenA.
struct EndTension {
  std::string line;
  bool is_at_start = false;
};
std::optional<EndTension> end_tension_named(const std::string& name);

}  // namespace netloft::scenes
