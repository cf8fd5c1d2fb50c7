// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/moordyn_words.hpp"

#include <algorithm>
#include <utility>

namespace netloft::scenes {

namespace {

constexpr const char* kComputing = "it controls how MoorDyn computes";
constexpr const char* kWriting = "it controls what MoorDyn writes";
constexpr const char* kFriction =
    "friction of the bed: in MoorDyn it grows with the speed and is zero at rest; in the scene, "
    "seabed.friction sticks until a line slides";
constexpr const char* kOfFriction = "it belongs to the friction of the bed";
constexpr const char* kOfWater = "it belongs to waves and currents, which are not read";
constexpr const char* kInertia = "forces of inertia on coupled bodies act in a motion";

struct Option {
  const char *name, *meaning;
};
constexpr Option kOptions[] = {{"DTM", kComputing},
                               {"DT", kComputing},
                               {"CFL", kComputing},
                               {"TSCHEME", kComputing},
                               {"DTIC", kComputing},
                               {"ICDT", kComputing},
                               {"TMAXIC", kComputing},
                               {"ICTMAX", kComputing},
                               {"CDSCALEIC", kComputing},
                               {"ICDFAC", kComputing},
                               {"THRESHIC", kComputing},
                               {"ICTHRESH", kComputing},
                               {"ICGENDYNAMIC", kComputing},
                               {"WRITELOG", kWriting},
                               {"WRITEUNITS", kWriting},
                               {"DTOUT", kWriting},
                               {"DISABLEOUTPUT", kWriting},
                               {"DISABLEOUTTIME", kWriting},
                               {"OUTSWITCH", kWriting},
                               {"CBOT", "damping of the bed acts in a motion"},
                               {"CB", "damping of the bed acts in a motion"},
                               {"FRICTIONCOEFFICIENT", kFriction},
                               {"MU_KT", kFriction},
                               {"MU_KA", kFriction},
                               {"FRICDAMP", kOfFriction},
                               {"CV", kOfFriction},
                               {"STATDYNFRICSCALE", kOfFriction},
                               {"MC", kOfFriction},
                               {"DTWAVE", kOfWater},
                               {"WAVEKIN_RAMPT", kOfWater},
                               {"UNIFYCURRENTGRID", kOfWater},
                               {"INERTIALF", kInertia},
                               {"INERTIALF_RAMPT", kInertia}};

}  // namespace

std::string in_capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

MoordynSection section_named(const std::string& title) {
  using enum MoordynSection;
  // The first matching entry is used. Therefore ROD TYPES must come before RODS.
  static const std::pair<const char*, MoordynSection> known[] = {{"LINE TYPES", line_types},
                                                                 {"LINE DICTIONARY", line_types},
                                                                 {"ROD TYPES", rod_types},
                                                                 {"ROD DICTIONARY", rod_types},
                                                                 {"BODIES", bodies},
                                                                 {"BODY", bodies},
                                                                 {"RODS", rods},
                                                                 {"ROD ", rods},
                                                                 {"POINT", points},
                                                                 {"CONNECTION", points},
                                                                 {"NODE PROP", points},
                                                                 {"LINES", lines},
                                                                 {"LINE LIST", lines},
                                                                 {"LINE PROP", lines},
                                                                 {"OPTIONS", options},
                                                                 {"OUTPUT", outputs}};
  for (const auto& [words, section] : known)
    if (title.find(words) != std::string::npos) return section;
  return other;
}

std::optional<std::string> meaning_of_option(const std::string& name) {
  const auto* option = std::ranges::find(kOptions, name, &Option::name);
  return option == std::end(kOptions) ? std::nullopt : std::optional<std::string>(option->meaning);
}

bool is_option_of_water(const std::string& name) {
  return name == "WAVEKIN" || name == "CURRENTS" || name == "WATERKIN";
}

std::optional<EndTension> end_tension_named(const std::string& name) {
  const auto line_between = [&](std::string_view before, std::string_view behind) -> std::string {
    if (!name.starts_with(before) || !name.ends_with(behind) || name.size() <= before.size() + behind.size())
      return {};
    const std::string line = name.substr(before.size(), name.size() - before.size() - behind.size());
    return std::ranges::all_of(line, [](char c) { return c >= '0' && c <= '9'; }) ? line : "";
  };
  const struct {
    const char *before, *behind;
    bool is_at_start;
  } names[] = {{"FAIRTEN", "", false}, {"ANCHTEN", "", true}, {"LINE", "TENB", false},
               {"LINE", "TENA", true}, {"LINE", "TB", false}, {"LINE", "TA", true}};
  for (const auto& n : names)
    if (const std::string line = line_between(n.before, n.behind); !line.empty())
      return EndTension{line, n.is_at_start};
  return {};
}

}  // namespace netloft::scenes
