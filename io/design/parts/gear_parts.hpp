// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/parts/part_templates.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/net_plan.hpp"

#include <array>
#include <map>

namespace netloft::design {

/// A gear to which parts are added, and from which parts are removed.
struct PartedGear {
  formats::Value root;  // tables of the scene
  gears::NetPlan plan;
  gears::Catalogue catalogue;
  /// Positions of the points of the plan in the last equilibrium, as far as they are known [m].
  std::map<std::string, std::array<double, 3>> points = {};
};

/// Values of the fields of a template, by their names.
using PartChoices = std::map<std::string, std::string>;

/// The values that can be chosen for a field; empty if it is a number.
std::vector<std::string> choices_of(const PartField& field, const PartedGear& gear);

/// The names of parts that can be removed: "floats.headline".
std::vector<std::string> parts_of(const formats::Value& root);

/// Documents with another part, in the ways of its template, the likeliest first. Throws Refused if a choice
/// is missing or wrong, or if there is no net plan.
std::vector<formats::Value> with_part(const PartedGear& gear, const PartTemplate& kind, PartChoices choices);

/// The document without a part, with its seams and hangings. Throws Refused if there is no such part.
formats::Value without_part(formats::Value root, const std::string& part);

}  // namespace netloft::design
