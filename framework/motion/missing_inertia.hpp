// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <optional>

namespace netloft {

/// A degree of freedom without inertia: it can move, but would be accelerated without bound in a motion.
struct MissingInertia {
  std::uint32_t node = 0;                // the origin, if it is a body
  std::optional<std::size_t> body = {};  // index in the scene
  bool is_of_turning = false;            // a body without inertia about some axis through its centre of mass
  bool is_on(const Part& part) const;    // whether one of its elements has the node
};

/// Finds bodies that can turn and whose own elements give no inertia about some axis. The elements joined to
/// their points give a little inertia, with which the body would turn at any speed. Massless nodes are found
/// only `with_nodes`: explicit schemes divide by their masses, whereas implicit schemes assume them to be in
/// equilibrium. Masses are those at the start. Returns none if they cannot be evaluated there, see
/// Assembler::fault.
std::vector<MissingInertia> find_missing_inertia(const Scene& scene, const ScenePlan& plan,
                                                 Assembler& assembler, bool with_nodes);

}  // namespace netloft
