// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace netloft {

/// Copies a struct of the boundary to where a plugin has made room for it, which may have been built against
/// an older interface, whose struct is shorter. How much room there is the plugin says in `size`, which then
/// says how much is filled. Interfaces before 1.4 did not ask for that: whatever stands there, room for
/// `least` there is.
template <class T>
void hand_out(const T& own, T& theirs, std::size_t least) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  const std::size_t room = std::min(std::max(std::size_t{theirs.size}, least), sizeof(T));
  std::memcpy(&theirs, &own, room);
  theirs.size = static_cast<std::uint32_t>(room);
}

/// What the structs of interfaces before 1.4 hold, up to their last function.
inline constexpr std::size_t kProblemBefore14 = offsetof(netloft_problem, evaluate_both),
                             kMembersBefore14 = offsetof(netloft_members, progress) + sizeof(void*);

}  // namespace netloft
