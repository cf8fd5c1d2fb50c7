// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/strategy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace netloft {

/// Copies a struct of the boundary to where a plugin has made room for it. The plugin may have been built
/// with an older header, whose struct is shorter: its `size` says how much room there is, and afterwards how
/// much is filled. Every plugin has room for `least` bytes, whatever it says.
template <class T>
void hand_out(const T& own, T& theirs, std::size_t least) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  const std::size_t room = std::min(std::max(std::size_t{theirs.size}, least), sizeof(T));
  std::memcpy(&theirs, &own, room);
  theirs.size = static_cast<std::uint32_t>(room);
}

/// The structs as "netloft.solver/1" and "netloft.strategy/1" had them at first, up to their last function.
inline constexpr std::size_t kFirstProblem = offsetof(netloft_problem, evaluate_both) + sizeof(void*),
                             kFirstMembers = offsetof(netloft_members, progress) + sizeof(void*);

}  // namespace netloft
