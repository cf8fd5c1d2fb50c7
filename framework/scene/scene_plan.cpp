// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/scene_plan.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace netloft {

namespace {

/// Whether water moves past the gear, because the water flows or because the gear moves through it.
bool meets_flow(const Scene& scene, AnalysisKind kind) {
  return scene.current.flows() || (kind == AnalysisKind::dynamics && scene.water.density > 0);
}

/// The properties that all parts of a family have in common.
struct FamilyKey {
  const ElementType* type;
  double viscosity_ratio;
  std::optional<std::uint32_t> flow;                 // flow that changes the water
  std::vector<std::pair<std::string, Values>> laws;  // type and parameters of the law in each slot; empty if
                                                     // no term reads laws

  bool operator<(const FamilyKey& other) const {
    return std::tie(type, viscosity_ratio, flow, laws) <
           std::tie(other.type, other.viscosity_ratio, other.flow, other.laws);
  }
};

FamilyKey key_of(const Part& part, const ElementType& type, bool asks_laws) {
  const bool is_plain = !type.is_on_body() && type.globals.empty();
  const bool is_in_flow =
      asks_laws && is_plain && std::ranges::any_of(type.terms, [](const netloft_term& term) {
        return sees_changed_water(term.traits);
      });
  FamilyKey key{&type, part.viscosity_ratio, is_in_flow ? part.flow : std::nullopt, {}};
  if (!asks_laws) return key;
  for (const auto& slot : type.laws)
    if (const auto given = part.laws.find(slot.name); given != part.laws.end())
      key.laws.emplace_back(given->second.type, given->second.parameters);
    else
      key.laws.emplace_back(slot.fallback, Values{});
  return key;
}

/// Looks up the laws that a part has chosen.
std::vector<LawPlan> laws_of(const Part& part, const FamilyKey& key, Registry& registry) {
  std::vector<LawPlan> laws(key.type->laws.size());
  for (std::size_t i = 0; i < key.laws.size(); ++i) {
    const auto& slot = key.type->laws[i];
    const auto& [type, parameters] = key.laws[i];
    laws[i] = {slot.name, &registry.law(type), {type, parameters}};
    if (!(laws[i].type->law.kind & slot.accepts))
      throw SceneError(
          {{part.name, type + " is not a law that " + key.type->type + " can use as its " + slot.name}});
  }
  return laws;
}

/// Sorts parts into families (elements of one type with the same laws). Laws are looked up only for the first
/// part of a family.
class FamilySorter {
 public:
  FamilySorter(const Scene& scene, Registry& registry, AnalysisKind kind)
      : registry_(registry), asks_laws_(meets_flow(scene, kind)) {}

  /// Finds or makes the family to which a part belongs.
  FamilyPlan& family_of(const Part& part, std::vector<FamilyPlan>& families) {
    const ElementType& type = registry_.element(part.type);
    FamilyKey key = key_of(part, type, asks_laws_);
    if (const auto known = known_.find(key); known != known_.end()) return families[known->second];
    families.push_back({&type, laws_of(part, key, registry_), {}, 0, {}, {}, part.viscosity_ratio, key.flow});
    known_.emplace(std::move(key), families.size() - 1);
    return families.back();
  }

 private:
  Registry& registry_;
  bool asks_laws_;
  std::map<FamilyKey, std::size_t> known_;  // indices of families
};

bool any_part_sets(std::string_view name, const FamilyPlan& family, const Scene& scene) {
  return std::any_of(family.parts.begin(), family.parts.end(),
                     [&](std::uint32_t part) { return sets(scene.parts[part], *family.type, name); });
}

/// The first parameter that a term needs and that differs from zero in some part; empty if there is none.
std::string first_set(const netloft_term& term, const FamilyPlan& family, const Scene& scene) {
  for (const auto& name : names_needed_by(term))
    if (any_part_sets(name, family, scene)) return name;
  return "";
}

/// A reason such as "EA and EA_compression are zero".
std::string all_are_zero(const std::vector<std::string>& names) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += " and " + names[i];
  return text + (names.size() > 1 ? " are zero" : " is zero");
}

/// Finds the unknowns that the elements of each part share. Some exist only if a certain parameter of the
/// part is not zero. If no term is active, nothing would determine them, and none exists.
void find_globals(FamilyPlan& family, const Scene& scene) {
  if (std::ranges::none_of(family.terms, &TermPlan::on)) return;
  for (const auto part : family.parts)
    for (const auto& g : family.type->globals)
      if (!g.needs || sets(scene.parts[part], *family.type, g.needs))
        family.globals.push_back({part, g.name, g.unit, g.doc});
}

/// Refuses unknowns that a part shares if the tangent is not exact, because their equations would be
/// singular.
void check_globals(const FamilyPlan& family, const ScenePlan& plan, const Scene& scene) {
  if (family.globals.empty() || plan.tangent == TangentChoice::exact) return;
  const GlobalPlan& first = family.globals.front();
  throw SceneError({{scene.parts[first.part].name,
                     "its " + first.name + " is an unknown (" + first.doc +
                         "): a scene with such an unknown needs analysis.tangent = \"exact\""}});
}

/// Refuses flows in motions: the water behind a gear follows the speed of the gear with a delay, which no
/// flow describes.
void check_flow(const FamilyPlan& family, const ScenePlan& plan, const Scene& scene) {
  if (!family.flow || plan.kind == AnalysisKind::statics) return;
  const Part& flow = scene.parts[*family.flow];
  throw SceneError(
      {{flow.name, flow.type + " describes water that has become steady, so it cannot be used in a motion: "
                               "the water behind a gear follows with a delay of about the width of the "
                               "mouth over the speed"}});
}

/// If a flow changes the water of a term, adds the name of the flow to the reason of the term.
void note_flow(FamilyPlan& family, const Scene& scene) {
  if (!family.flow) return;
  for (TermPlan& term : family.terms)
    if (term.on && sees_changed_water(term.traits))
      term.reason += "; the water is that of " + scene.parts[*family.flow].name;
}

TermPlan decide(const netloft_term& term, const FamilyPlan& family, const Scene& scene, AnalysisKind kind) {
  TermPlan plan{term.name, term.doc, term.traits, false, ""};
  const std::string set = term.needs ? first_set(term, family, scene) : "";
  if (term.needs && set.empty())
    plan.reason = all_are_zero(names_needed_by(term));
  else if ((term.traits & NETLOFT_NEEDS_GRAVITY) && scene.water.gravity == 0)
    plan.reason = "the scene has no gravity";
  else if ((term.traits & NETLOFT_NEEDS_FLOW) && !meets_flow(scene, kind))
    plan.reason = kind == AnalysisKind::statics ? "the scene has no current" : "the scene has no water";
  else if ((term.traits & NETLOFT_NEEDS_MOTION) && kind == AnalysisKind::statics) {
    plan.reason = "the analysis is static";
    plan.when_it_moves = !(term.traits & NETLOFT_NEEDS_WAVES);
  } else if ((term.traits & NETLOFT_NEEDS_WAVES) && !scene.waves)
    plan.reason = "the scene has no waves";
  else {
    plan.on = true;
    plan.reason = term.needs ? set + " is set" : "the scene has what it needs";
  }
  return plan;
}

void note_traits(ScenePlan& plan, const FamilyPlan& family, const TermPlan& term) {
  if (!term.on || (term.traits & NETLOFT_CONSTANT) || plan.tangent != TangentChoice::exact) return;
  if (!(term.traits & NETLOFT_SYMMETRIC) && plan.symmetric) {
    plan.symmetric = false;
    plan.unsymmetric_because = family.type->type + " " + term.name;
  }
}

/// Rotating bodies have forces that depend on their angular velocity, with an unsymmetric tangent.
void note_turning(ScenePlan& plan, const Scene& scene) {
  const bool is_exact = plan.kind == AnalysisKind::dynamics && plan.tangent == TangentChoice::exact;
  if (!is_exact || scene.bodies.empty() || !plan.symmetric) return;
  plan.symmetric = false;
  plan.unsymmetric_because = scene.bodies[0].name + ", a rotating body";
}

void count_unknowns(ScenePlan& plan, const Scene& scene) {
  plan.nodes = scene.node_count();
  for (const auto held : scene.held) {
    if (held) ++plan.held_nodes;
    for (int axis = 0; axis < 3; ++axis) plan.unknowns += !(held & (1 << axis));
  }
  for (const auto& body : scene.bodies)
    for (int axis = 0; axis < 3; ++axis) plan.unknowns += !(body.held_rotation & (1 << axis));
  plan.bodies = scene.bodies.size();
}

}  // namespace

ScenePlan make_scene_plan(const Scene& scene, Registry& registry, TangentChoice tangent, AnalysisKind kind) {
  ScenePlan plan;
  plan.tangent = tangent;
  plan.kind = kind;
  plan.ground = scene.ground;
  FamilySorter sorter(scene, registry, kind);
  for (std::uint32_t p = 0; p < scene.parts.size(); ++p) {
    FamilyPlan& family = sorter.family_of(scene.parts[p], plan.families);
    family.parts.push_back(p);
    family.elements += scene.parts[p].nodes.size() / static_cast<std::size_t>(family.type->nodes());
  }
  for (auto& family : plan.families) {
    for (const auto& term : family.type->terms) {
      family.terms.push_back(decide(term, family, scene, kind));
      note_traits(plan, family, family.terms.back());
      plan.conservative &= !family.terms.back().on || (term.traits & NETLOFT_CONSERVATIVE);
    }
    find_globals(family, scene);
    check_globals(family, plan, scene);
    check_flow(family, plan, scene);
    note_flow(family, scene);
    plan.unknowns += family.globals.size();
  }
  count_unknowns(plan, scene);
  note_turning(plan, scene);
  return plan;
}

void use_mean_forces(ScenePlan& plan, const std::string& integrator) {
  plan.between = true;
  if (!plan.symmetric) return;
  plan.symmetric = false;
  plan.unsymmetric_because = integrator + ", which uses mean forces of a step";
}

bool ScenePlan::reads_ground() const {
  for (const auto& family : families)
    for (const auto& term : family.terms)
      if (term.on && (term.traits & NETLOFT_READS_GROUND)) return true;
  return false;
}

std::vector<std::string> unused_plugins(const ScenePlan& plan, const Registry& registry) {
  auto names = registry.available();
  for (const auto& family : plan.families) {
    std::erase(names, family.type->origin->name);
    for (const auto& law : family.laws)
      if (law.type) std::erase(names, law.type->origin->name);
  }
  return names;
}

namespace {

/// Whether a parameter has no default and is not given.
bool is_left_out(const Part& part, const ElementType& type, std::string_view parameter) {
  for (const auto& p : type.parameters)
    if (std::string_view(p.name) == parameter)
      return p.kind == NETLOFT_REAL && p.fallback == 0 && !p.fallback_of && !part.parameters.contains(p.name);
  return true;
}

}  // namespace

bool sets(const Part& part, const ElementType& type, std::string_view parameter) {
  if (is_left_out(part, type, parameter)) return false;
  if (const auto given = part.parameters.find(std::string(parameter)); given != part.parameters.end())
    if (const auto* number = std::get_if<double>(&given->second)) return *number != 0;
  std::vector<std::string> faults;
  const ParameterBlock block(type.parameters, type.element.parameter_bytes, part.parameters, faults);
  for (const auto& p : type.parameters)
    if (faults.empty() && std::string_view(p.name) == parameter && block.number(p) != 0) return true;
  return false;
}

std::string describe_traits(std::uint32_t traits) {
  static constexpr std::pair<std::uint32_t, const char*> kNames[] = {
      {NETLOFT_CONSERVATIVE, "conservative"},
      {NETLOFT_SYMMETRIC, "symmetric"},
      {NETLOFT_CONSTANT, "constant"},
      {NETLOFT_READS_VELOCITY, "reads velocity"},
      {NETLOFT_READS_ACCELERATION, "reads acceleration"},
      {NETLOFT_READS_CURRENT, "reads current"},
      {NETLOFT_READS_TIME, "reads time"},
      {NETLOFT_NEEDS_GRAVITY, "needs gravity"},
      {NETLOFT_NEEDS_FLOW, "needs flow"},
      {NETLOFT_NEEDS_MOTION, "needs motion"},
      {NETLOFT_OF_MEMBERS, "of members"},
      {NETLOFT_IS_WEIGHT, "weight"},
      {NETLOFT_IS_DRAG, "drag"},
      {NETLOFT_READS_GROUND, "reads ground"},
      {NETLOFT_READS_BED, "reads bed"},
      {NETLOFT_READS_WAVES, "reads waves"},
      {NETLOFT_NEEDS_WAVES, "needs waves"}};
  std::string text;
  for (const auto& [bit, name] : kNames)
    if (traits & bit) text += (text.empty() ? "" : ", ") + std::string(name);
  return text.empty() ? "none" : text;
}

}  // namespace netloft
