// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/plan_contact.hpp"

#include "io/formats/units/units.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace netloft::scenes {

namespace {

/// A length from the plan or the catalogue [m]; 0 if the value is no length, which is reported elsewhere.
double metres_of(const formats::Value& value) {
  if (const auto* number = value.as<double>()) return *number;
  if (const auto* number = value.as<std::int64_t>()) return static_cast<double>(*number);
  const auto* text = value.as<std::string>();
  return text ? formats::to_si(*text, "m").value : 0;
}

}  // namespace

const GearElements& contact_elements() {
  return *std::ranges::find_if(gear_elements(),
                               [](const auto& of) { return of.kind == std::string_view(kContact); });
}

formats::Value without_contact(formats::Value said) {
  std::erase_if(said.as<formats::Table>()->members,
                [](const formats::Member& member) { return member.key == contact_elements().key; });
  return said;
}

formats::Value only_contact(formats::Value said) {
  std::erase_if(said.as<formats::Table>()->members,
                [](const formats::Member& member) { return member.key != contact_elements().key; });
  return said;
}

bool rests_on_bed(const gears::Rope& rope) {
  static const std::set<std::string> roles = {"footrope", "fishing-line", "ground-rope", "bridle",
                                              "sweep",    "backstrap",    "door-leg"};
  return roles.contains(rope.role);
}

std::vector<std::string> shoes_of(const gears::PlanBody& body) {
  std::vector<std::string> shoes;
  for (const char* side : {"", "port-", "starboard-"})
    for (const char* end : {"toe", "heel"})
      if (const std::string point = std::string(side) + end; body.find_point(point))
        shoes.push_back(body.name + "." + point);
  return shoes;
}

double radius_along(const gears::NetPlan& plan, const std::string& rope) {
  double widest = 0;
  for (const gears::Pieces& pieces : plan.pieces) {
    const formats::Table* numbers = pieces.along == rope ? pieces.piece.as<formats::Table>() : nullptr;
    const formats::Member* diameter = numbers ? numbers->find("diameter") : nullptr;
    if (diameter) widest = std::max(widest, metres_of(diameter->value));
  }
  return widest / 2;
}

}  // namespace netloft::scenes
