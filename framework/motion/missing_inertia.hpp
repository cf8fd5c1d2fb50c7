// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <optional>

namespace netloft {

/// What a motion would accelerate without bound: it can move, and no element gives it inertia.
struct MissingInertia {
  std::uint32_t node = 0;                // of a body its origin
  std::optional<std::size_t> body = {};  // index in the scene
  bool is_of_turning = false;            // of a body: about some axis through its centre of mass; else mass
  bool is_on(const Part& part) const;    // one of its elements has the node
};

/// Bodies that can turn and whose own elements give no inertia about some axis: what is joined to their
/// points gives a little, and with it turns of any speed, which steps in time would follow. Nodes are looked
/// at only `with_nodes`: explicit schemes divide by their masses; implicit ones take those without for always
/// in equilibrium. At the start; none if masses cannot be evaluated there, see the assembler's fault().
std::vector<MissingInertia> find_missing_inertia(const Scene& scene, const ScenePlan& plan,
                                                 Assembler& assembler, bool with_nodes);

}  // namespace netloft
