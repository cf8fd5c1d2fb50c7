// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <optional>

namespace netloft {

/// A degree of freedom that can move but has no inertia, so that nothing would bound its acceleration in a
/// motion.
struct MissingInertia {
  std::uint32_t node = 0;                // number of the node; for a body, its origin
  std::optional<std::size_t> body = {};  // index of the body in the scene
  bool is_of_turning = false;  // whether the body has no inertia about some axis through its centre of mass
  bool is_on(const Part& part) const;  // whether an element of the part has this node
};

/// Finds bodies whose own elements give them no mass, or no inertia about some axis about which they can
/// turn. (Elements joined to points of the body are not counted: they add so little inertia that nothing
/// would limit the speed at which the body turns.) Massless nodes are found only if `with_nodes`: explicit
/// schemes divide by the masses of nodes, whereas implicit schemes assume massless nodes to be in
/// equilibrium. Masses are evaluated at the start. Returns an empty list if this fails, see Assembler::fault.
std::vector<MissingInertia> find_missing_inertia(const Scene& scene, const ScenePlan& plan,
                                                 Assembler& assembler, bool with_nodes);

}  // namespace netloft
