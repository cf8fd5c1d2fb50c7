// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/variants.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>

namespace netloft {

netloft_variant as_written() { return {sizeof(netloft_variant), 0, 0, 1, 1}; }

bool is_as_written(const netloft_variant& v) {
  return v.level == 0 && v.stiffness_cap == 0 && v.compression == 1 && v.current == 1;
}

bool is_same(const netloft_variant& a, const netloft_variant& b) {
  return a.level == b.level && a.stiffness_cap == b.stiffness_cap && a.compression == b.compression &&
         a.current == b.current;
}

netloft_variant combined(const netloft_variant& outer, const netloft_variant& inner) {
  netloft_variant both = as_written();
  both.level = outer.level + inner.level;
  const bool has_both = outer.stiffness_cap > 0 && inner.stiffness_cap > 0;
  both.stiffness_cap = has_both ? std::min(outer.stiffness_cap, inner.stiffness_cap)
                                : std::max(outer.stiffness_cap, inner.stiffness_cap);
  both.compression = outer.compression * inner.compression;
  both.current = outer.current * inner.current;
  return both;
}

std::string text_of(const netloft_variant& v) {
  std::string text;
  const auto add = [&](const char* format, double number) {
    char word[64];
    std::snprintf(word, sizeof word, format, number);
    text += (text.empty() ? "" : ", ") + std::string(word);
  };
  if (v.level > 0) add("elements x %.0f", static_cast<double>(1u << v.level));
  if (v.stiffness_cap > 0) add("stiffness up to %.3g N", v.stiffness_cap);
  if (v.compression == 0) add("no compression", 0);
  if (v.compression > 0 && v.compression < 1) add("compression x %.3g", v.compression);
  if (v.current == 0) add("still water", 0);
  if (v.current > 0 && v.current < 1) add("current x %.3g", v.current);
  return text;
}

namespace {

double value_of(const Part& part, const ElementType& type, const netloft_parameter& parameter) {
  std::vector<std::string> faults;
  const ParameterBlock block(type.parameters, type.element.parameter_bytes, part.parameters, faults);
  return faults.empty() ? block.number(parameter) : 0.0;
}

/// Whether a stiffness is axial (in newtons); the stiffness of a hinge or of the ground is not.
bool is_in_newtons(const netloft_parameter& parameter) { return std::strcmp(parameter.unit, "N") == 0; }

/// Calls visit(part, type, parameter) for every real parameter with the role.
template <class PartOf, class Visit>
void for_role(PartOf& parts, Registry& registry, std::uint32_t role, Visit&& visit) {
  for (auto& part : parts) {
    const ElementType& type = registry.element(part.type);
    for (const auto& parameter : type.parameters)
      if (parameter.flags & role) visit(part, type, parameter);
  }
}

/// Largest axial stiffness for each name of a part. A part and its companions (on pairs of its elements) have
/// the same name.
std::map<std::string, double> stiffness_by_name(const Scene& scene, Registry& registry) {
  std::map<std::string, double> largest;
  for_role(scene.parts, registry, NETLOFT_STIFFNESS, [&](const Part& part, const auto& type, const auto& p) {
    if (is_in_newtons(p)) largest[part.name] = std::max(largest[part.name], value_of(part, type, p));
  });
  return largest;
}

void weaken_compression(Scene& scene, Registry& registry, double factor) {
  for_role(scene.parts, registry, NETLOFT_COMPRESSION, [&](Part& part, const auto& type, const auto& p) {
    part.parameters[p.name] = std::max(p.lo, factor * value_of(part, type, p));
  });
}

void cap_stiffness(Scene& scene, Registry& registry, double cap) {
  const auto largest = stiffness_by_name(scene, registry);
  for_role(scene.parts, registry, NETLOFT_STIFFNESS | NETLOFT_COMPRESSION,
           [&](Part& part, const auto& type, const auto& p) {
             const auto own = largest.find(part.name);
             if (own == largest.end() || own->second <= cap) return;
             // A parameter whose default is another stiffness changes with that stiffness.
             const bool given = part.parameters.contains(p.name) || !p.fallback_of;
             const double value = value_of(part, type, p);
             if (given && value > 0) part.parameters[p.name] = std::max(p.lo, value * (cap / own->second));
           });
}

void scale_current(Scene& scene, double factor) {
  const auto scale = [factor](auto& samples) {
    for (auto& sample : samples)
      for (double& component : sample.velocity) component *= factor;
  };
  scale(scene.current.samples);
  scale(scene.current.drifts);
  for (double& component : scene.current.tow) component *= factor;
}

}  // namespace

Scene make_variant(const Scene& scene, Registry& registry, const netloft_variant& variant) {
  Scene easier = scene;
  if (variant.compression != 1) weaken_compression(easier, registry, variant.compression);
  if (variant.stiffness_cap > 0) cap_stiffness(easier, registry, variant.stiffness_cap);
  if (variant.current != 1) scale_current(easier, variant.current);
  return easier;
}

double largest_stiffness(const Scene& scene, Registry& registry) {
  double largest = 0;
  for (const auto& [name, stiffness] : stiffness_by_name(scene, registry))
    largest = std::max(largest, stiffness);
  return largest;
}

bool resists_compression(const Scene& scene, Registry& registry) {
  bool resists = false;
  for_role(
      scene.parts, registry, NETLOFT_COMPRESSION,
      [&](const Part& part, const auto& type, const auto& p) { resists |= value_of(part, type, p) > 0; });
  return resists;
}

}  // namespace netloft
