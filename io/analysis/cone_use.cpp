// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/cone_use.hpp"

#include "framework/problem/static_problem.hpp"
#include "io/analysis/axial_members.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

/// What is slack bears nothing.
bool bears_tension_only(const std::vector<AxialMember>& members) {
  return std::all_of(members.begin(), members.end(),
                     [](const AxialMember& m) { return m.EA_compression == 0; });
}

}  // namespace

ConeUse use_of_cones(const Scene& scene, Registry& registry, Assembler& assembler) {
  if (!scene.bodies.empty() || !scene.frames.empty() || !assembler.memory().empty()) return ConeUse::never;
  const auto members = axial_members(scene, registry);
  if (members.size() <= static_cast<std::size_t>(assembler.pattern().size)) return ConeUse::never;
  if (load_of(assembler) == 0) return ConeUse::never;
  return scene.current.flows() || bears_tension_only(members) ? ConeUse::first : ConeUse::as_a_way;
}

double load_of(Assembler& assembler) {
  return StaticProblem(assembler, make_factorisation, {}).driving_load().sum;
}

}  // namespace netloft::io
