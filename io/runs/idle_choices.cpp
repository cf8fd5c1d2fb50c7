// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/idle_choices.hpp"

#include "framework/registry/descriptors.hpp"

#include <algorithm>
#include <set>

namespace netloft::runs {

namespace {

/// A setting without effect ("rope.damping"), the reason ("the analysis is static"), and the parts that have
/// it.
struct IdleChoice {
  std::string what, reason, first_part;
  std::set<std::string> parts;
};

bool needs(const netloft_term& term, const std::string& parameter) {
  const auto names = names_needed_by(term);
  return std::find(names.begin(), names.end(), parameter) != names.end();
}

/// The reason why a parameter has no effect: no force term that needs it is evaluated. Empty if such a term
/// is evaluated, or if no term needs the parameter. Also empty for terms that need a flow, because their
/// parameters (such as a diameter) have other uses; and for terms that act only in a motion, if a motion
/// decides whether the equilibrium is stable.
std::string why_idle(const FamilyPlan& family, const std::string& parameter, bool motion_is_asked_for) {
  std::string reason;
  for (std::size_t t = 0; t < family.terms.size(); ++t) {
    if (!needs(family.type->terms[t], parameter)) continue;
    const TermPlan& term = family.terms[t];
    if (term.on || (term.traits & NETLOFT_NEEDS_FLOW) || (term.when_it_moves && motion_is_asked_for))
      return "";
    reason = term.reason;
  }
  return reason;
}

class IdleChoices {
 public:
  explicit IdleChoices(const ScenePlan& plan) : motion_is_asked_for_(!plan.conservative) {}

  void look_at(const FamilyPlan& family, const Part& part) {
    for (const auto& [name, value] : part.parameters)
      if (const double* number = std::get_if<double>(&value); number && *number != 0)
        add(part, name, why_idle(family, name, motion_is_asked_for_));
    const bool uses_laws =
        std::any_of(family.laws.begin(), family.laws.end(), [](const LawPlan& law) { return law.type; });
    for (const auto& [slot, law] : part.laws)
      if (!uses_laws) add(part, slot + " = \"" + law.type + "\"", "no water flows past it");
  }

  const std::vector<IdleChoice>& found() const { return found_; }

 private:
  void add(const Part& part, const std::string& what, const std::string& reason) {
    if (reason.empty()) return;
    const auto known = std::find_if(found_.begin(), found_.end(), [&](const IdleChoice& c) {
      return c.what == what && c.reason == reason;
    });
    IdleChoice& choice =
        known == found_.end() ? found_.emplace_back(IdleChoice{what, reason, part.name, {}}) : *known;
    choice.parts.insert(part.name);
  }

  bool motion_is_asked_for_;
  std::vector<IdleChoice> found_;
};

std::string parts_of(const IdleChoice& choice) {
  const std::size_t more = choice.parts.size() - 1;
  return choice.first_part + (more ? " and " + std::to_string(more) + " more" : "");
}

}  // namespace

void warn_of_idle_choices(const scenes::LoadedScene& loaded, const ScenePlan& plan,
                          formats::Diagnostics& diagnostics) {
  IdleChoices choices(plan);
  for (const FamilyPlan& family : plan.families)
    for (const auto part : family.parts) choices.look_at(family, loaded.scene.parts[part]);
  for (const IdleChoice& c : choices.found())
    diagnostics.warning(loaded.place_of(c.first_part),
                        parts_of(c) + ": " + c.what + " has no effect: " + c.reason);
}

}  // namespace netloft::runs
