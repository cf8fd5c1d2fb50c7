// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace netloft {

/// Copies a struct of the boundary to where a plugin has made room for it. The plugin may have been built
/// against an older interface, whose struct is shorter: it says so in `size`, which then says how much of it
/// is filled. `unsaid` is the room of a plugin that left `size` at zero, as those before interface 1.4 do.
template <class T>
void hand_out(const T& own, T& theirs, std::size_t unsaid) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  const std::size_t room = std::min(theirs.size > 0 ? std::size_t{theirs.size} : unsaid, sizeof(T));
  std::memcpy(&theirs, &own, room);
  theirs.size = static_cast<std::uint32_t>(room);
}

/// What structs of interfaces before 1.4 hold.
inline constexpr std::size_t kProblemBefore14 = offsetof(netloft_problem, evaluate_both),
                             kMembersBefore14 = sizeof(netloft_members);

}  // namespace netloft
