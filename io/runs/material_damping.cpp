// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/material_damping.hpp"

#include "framework/parameters/find_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace netloft::runs {

namespace {

// An element with a loss factor has three parameters with a common prefix: `rope.loss_factor`,
// `rope.loss_frequency`, `rope.damping`.
constexpr const char *kLoss = ".loss_factor", *kFrequency = ".loss_frequency", *kOwn = ".damping";

/// The parameter tables of a part's element type that have a loss factor: "rope" for `rope.loss_factor`.
std::vector<std::string> tables_with_loss(const Part& part, Registry& registry) {
  std::vector<std::string> tables;
  for (const auto& p : registry.element(part.type).parameters)
    if (const std::string_view name = p.name; name.ends_with(kLoss))
      tables.emplace_back(name.substr(0, name.size() - std::string_view(kLoss).size()));
  return tables;
}

/// The value of a parameter of the part, or its default; 0 if the elements have no such parameter.
double value_of(const Part& part, const std::string& name, Registry& registry) {
  const auto& known = registry.element(part.type).parameters;
  const auto at = std::ranges::find_if(known, [&](const auto& p) { return name == p.name; });
  return at == known.end() ? 0 : number_or(at->fallback, part.parameters, name);
}

/// The reason why loss factors are not used; empty if they are.
std::string why_off(const scenes::Analysis& analysis, Registry& registry) {
  if (analysis.settles) return "the analysis is static";
  const scenes::Dynamics& d = analysis.dynamics;
  if (!d.material_damping) return "material_damping = false";
  if (analysis.kind == AnalysisKind::statics) return "";
  if (d.stiffness_damping > 0) return "stiffness_damping replaces it";
  const IntegratorType& type = registry.integrator(d.integrator);
  std::vector<std::string> faults;
  const ParameterBlock block(type.parameters, type.integrator.parameter_bytes, d.integrator_parameters,
                             faults);
  const bool is_bounded = faults.empty() && type.integrator.stable_step(block.data(), 1) > 0;
  return is_bounded
             ? d.integrator + " is stable in short steps only, and material damping would make them shorter"
             : "";
}

struct Losses {
  double factor, frequency;
  bool operator<(const Losses& o) const {
    return factor != o.factor ? factor > o.factor : frequency < o.frequency;
  }
};

/// A list as text: "0.1 of net and 3 more, 0.02 of warp, at 10 Hz".
std::string listed(const std::map<Losses, std::vector<std::string>>& parts) {
  std::string text;
  for (const auto& [loss, names] : parts) {
    text += fmt::format("{}{:.3g} of {}", text.empty() ? "" : "; ", loss.factor, names.front());
    if (names.size() > 1) text += fmt::format(" and {} more", names.size() - 1);
    text += fmt::format(" at {:.3g} Hz", loss.frequency);
  }
  return text;
}

}  // namespace

std::string choose_material_damping(Scene& scene, const scenes::Analysis& analysis, Registry& registry) {
  std::map<Losses, std::vector<std::string>> losses;
  std::string off;
  for (Part& part : scene.parts)
    for (const auto& what : tables_with_loss(part, registry)) {
      const std::string name = what + kLoss;
      const double factor = value_of(part, name, registry);
      if (factor == 0) continue;
      if (off.empty()) off = why_off(analysis, registry);
      if (!off.empty() || number_or(0, part.parameters, what + kOwn) > 0)
        part.parameters[name] = 0.0;
      else
        losses[{factor, value_of(part, what + kFrequency, registry)}].push_back(part.name);
    }
  if (!off.empty()) return "off: " + off;
  return losses.empty() ? "" : "loss factor " + listed(losses);
}

void take_out_losses(Scene& scene, Registry& registry) {
  for (Part& part : scene.parts)
    for (const auto& what : tables_with_loss(part, registry))
      if (value_of(part, what + kLoss, registry) != 0) part.parameters[what + kLoss] = 0.0;
}

}  // namespace netloft::runs
