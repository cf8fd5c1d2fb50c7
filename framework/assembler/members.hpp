// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"

#include <netloft/ext/members.h>

#include <vector>

namespace netloft {

/// Whether the elements of a family have members (lines that bear tension) that act in this scene.
inline bool has_members(const ElementFamily& family) {
  return family.type().members.count > 0 && family.reads(NETLOFT_OF_MEMBERS);
}

/// The members of all elements of a family at time zero, [element][member]. The family must have members.
/// Throws std::runtime_error if the plugin cannot report the members or breaks a rule of the plugin
/// interface.
std::vector<netloft_member> members_of(const ElementFamily& family);

}  // namespace netloft
