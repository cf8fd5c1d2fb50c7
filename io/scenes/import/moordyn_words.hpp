// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

namespace netloft::scenes {

/// Converts to capitals, in which words of MoorDyn are compared.
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

/// The section that begins with this title, which is in capitals.
MoordynSection section_named(const std::string& title);

/// The effect in MoorDyn of an option that a scene cannot represent; nothing for an unknown option. `name` is
/// in capitals.
std::optional<std::string> meaning_of_option(const std::string& name);

/// Whether an option, in capitals, selects waves or currents.
bool is_option_of_water(const std::string& name);

/// An end of a line. An output such as FairTen3, Line3TenB, AnchTen3 or Line3TenA is the tension at this end.
struct EndTension {
  std::string line;
  bool is_at_start = false;
};
std::optional<EndTension> end_tension_named(const std::string& name);

}  // namespace netloft::scenes
