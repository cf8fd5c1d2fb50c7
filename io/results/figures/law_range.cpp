// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/law_range.hpp"

#include "io/formats/units/degrees.hpp"

#include <fmt/format.h>

namespace netloft::results {

namespace {

// Fractions are printed in whole per cent; fractions below this number would be printed as 0 %.
constexpr double kRoundsToNothing = 0.005;

std::string parts_text(const Scene& scene, const std::vector<std::uint32_t>& parts) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t p = 0; p < std::min(parts.size(), kNamed); ++p)
    text += (p ? ", " : "") + scene.parts[parts[p]].name;
  if (parts.size() > kNamed) text += fmt::format(" and {} more", parts.size() - kNamed);
  return text;
}

/// A range as text: "0.13 to 0.32", "up to 1e+05", "from 200"; angles are in degrees.
std::string range_text(const netloft_validity& range) {
  const bool is_angle = range.quantity == NETLOFT_ATTACK;
  const double unit = is_angle ? formats::in_radians(1) : 1;
  const std::string lo = fmt::format("{:.3g}", range.lo / unit), hi = fmt::format("{:.3g}", range.hi / unit);
  const std::string after = is_angle ? "°" : "";
  if (!(range.lo > 0)) return "up to " + hi + after;
  return std::isfinite(range.hi) ? lo + " to " + hi + after : "from " + lo + after;
}

std::string seen_text(const RangeUse& use) {
  const bool is_angle = use.range->quantity == NETLOFT_ATTACK;
  const double unit = is_angle ? formats::in_radians(1) : 1;
  return fmt::format("{:.3g} to {:.3g}{}", use.least / unit, use.most / unit, is_angle ? "°" : "");
}

}  // namespace

std::string validity_text(const netloft_validity& range) {
  std::string text =
      fmt::format("{} {}, {}", name_of_quantity(range.quantity), range_text(range), range.source);
  if (range.where) text += fmt::format("; with {}", range.where);
  if (range.unless) text += fmt::format("; without {}", range.unless);
  return text;
}

std::vector<std::string> law_range_warnings(const Scene& scene, const std::vector<LawUse>& uses) {
  std::vector<std::string> warnings;
  for (const LawUse& use : uses)
    for (const RangeUse& range : use.ranges)
      if (range.fraction_outside() >= kRoundsToNothing)
        warnings.push_back(
            fmt::format("{} was measured for a {} of {} ({}); {:.0f} % of the {} of {} lies outside this "
                        "range; the values are {}",
                        use.law->type, name_of_quantity(range.range->quantity), range_text(*range.range),
                        range.range->source, 100 * range.fraction_outside(),
                        use.law->law.kind == NETLOFT_SCREEN_LAW ? "area" : "length",
                        parts_text(scene, use.parts), seen_text(range)));
  return warnings;
}

}  // namespace netloft::results
