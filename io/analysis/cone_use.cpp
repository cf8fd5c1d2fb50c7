// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/cone_use.hpp"

#include "framework/problem/static_problem.hpp"
#include "io/analysis/axial_members.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

// Members stretch little where the stiffest would by this share under all of the load, and give way when
// pressed where none bears more than so many times the load. With more stretch, or as stiff as ropes that
// stand by themselves, they come to rest as soon without cones.
constexpr double kStretch = 0.1, kGivesWay = 10;

/// What is slack bears nothing, or next to nothing beside what is taut.
bool bears_tension_mainly(const std::vector<AxialMember>& members, double load) {
  double EA = 0, EA_compression = 0;
  for (const AxialMember& m : members)
    EA = std::max(EA, m.EA), EA_compression = std::max(EA_compression, m.EA_compression);
  return EA_compression == 0 || (load <= kStretch * EA && EA_compression <= kGivesWay * load);
}

}  // namespace

ConeUse use_of_cones(const Scene& scene, Registry& registry, Assembler& assembler) {
  if (!scene.bodies.empty() || !scene.frames.empty() || !assembler.memory().empty()) return ConeUse::never;
  const auto members = axial_members(scene, registry);
  const double load = load_of(assembler);
  if (members.empty() || load == 0) return ConeUse::never;
  const bool may_be_slack = members.size() > static_cast<std::size_t>(assembler.pattern().size);
  const bool first = scene.current.flows() ? may_be_slack : bears_tension_mainly(members, load);
  return first ? ConeUse::first : ConeUse::as_a_way;
}

double load_of(Assembler& assembler) {
  return StaticProblem(assembler, make_factorisation, {}).driving_load().sum;
}

}  // namespace netloft::io
