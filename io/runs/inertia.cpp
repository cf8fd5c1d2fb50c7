// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/inertia.hpp"

#include "framework/motion/missing_inertia.hpp"
#include "framework/parameters/find_number.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <set>

namespace netloft::runs {

namespace {

bool gives(const netloft_parameter& p, bool is_of_turning) {
  const std::string unit = p.unit ? p.unit : "";
  return is_of_turning ? unit == "kg m2" : unit == "kg" || unit == "kg/m" || unit == "kg/m3";
}

bool is_zero(const Part& part, const netloft_parameter& p) {
  return number_or(0, part.parameters, p.name) == 0;
}

/// Names of the parameters that would give the missing inertia, but are zero, such as "body.inertia_x,
/// body.inertia_y".
std::string keys_of(const Scene& scene, Registry& registry, const MissingInertia& missing) {
  std::string keys;
  std::set<std::string> named;
  for (const Part& part : scene.parts) {
    if (!missing.is_on(part)) continue;
    for (const netloft_parameter& p : registry.element(part.type).parameters)
      if (gives(p, missing.is_of_turning) && is_zero(part, p) && named.insert(p.name).second)
        keys += (keys.empty() ? "" : ", ") + std::string(p.name);
  }
  return keys;
}

std::string sentence(const Scene& scene, Registry& registry, const MissingInertia& missing) {
  const std::string what = missing.is_of_turning ? "moment of inertia about some axis" : "mass";
  const std::string keys = keys_of(scene, registry, missing);
  return (missing.body ? "the body " + formats::in_quotes(scene.bodies[*missing.body].name)
                       : scene.node_name(missing.node)) +
         " has no " + what + ", so that a force on it would accelerate it without bound" +
         (keys.empty() ? "" : "; these keys give it: " + keys);
}

}  // namespace

std::vector<SceneFault> find_missing_inertia(const Scene& scene, const ScenePlan& plan, Registry& registry,
                                             Assembler& assembler, bool is_explicit) {
  std::vector<SceneFault> faults;
  std::set<std::string> parts;  // parts with a reported fault; only one node of each part is reported
  for (const MissingInertia& missing : netloft::find_missing_inertia(scene, plan, assembler, is_explicit)) {
    const std::string& part = scene.parts[scene.labels[missing.node].part].name;
    if (missing.body || parts.insert(part).second)
      faults.push_back({part, sentence(scene, registry, missing)});
  }
  return faults;
}

}  // namespace netloft::runs
