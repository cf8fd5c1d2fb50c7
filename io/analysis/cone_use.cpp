// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/cone_use.hpp"

#include "framework/problem/static_problem.hpp"
#include "io/analysis/axial_members.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

// Stiffness of what is slack over the load, in a gear that may as well bear tension only.
constexpr double kNextToNothing = 5e-4;
// Load over stiffness of a gear in which what is slack is soon found to have its place.
constexpr double kSoftEnough = 1e-4;

bool bears_tension_only(const std::vector<AxialMember>& members, double load) {
  double pressed = 0, stiffest = 0;
  for (const AxialMember& m : members)
    pressed = std::max(pressed, m.EA_compression), stiffest = std::max(stiffest, m.EA);
  return pressed == 0 || (pressed <= kNextToNothing * load && load >= kSoftEnough * stiffest);
}

}  // namespace

ConeUse use_of_cones(const Scene& scene, Registry& registry, Assembler& assembler) {
  if (!scene.bodies.empty() || !scene.frames.empty() || !assembler.memory().empty()) return ConeUse::never;
  const auto members = axial_members(scene, registry);
  if (members.size() <= static_cast<std::size_t>(assembler.pattern().size)) return ConeUse::never;
  const double load = load_of(assembler);
  if (load == 0) return ConeUse::never;
  return scene.current.flows() || bears_tension_only(members, load) ? ConeUse::first : ConeUse::as_a_way;
}

double load_of(Assembler& assembler) {
  return StaticProblem(assembler, make_factorisation, {}).driving_load().sum;
}

}  // namespace netloft::io
