// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/strategy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace netloft {

/// Copies a struct of the plugin interface to memory that a plugin provides. The plugin may have been built
/// with an older header, whose struct is shorter. On input, `theirs.size` is the size of that memory; on
/// output, it is the number of bytes filled. This number is never less than `least`, even if the plugin
/// states a smaller size.
template <class T>
void hand_out(const T& own, T& theirs, std::size_t least) {
  static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
  const std::size_t room = std::min(std::max(std::size_t{theirs.size}, least), sizeof(T));
  std::memcpy(&theirs, &own, room);
  theirs.size = static_cast<std::uint32_t>(room);
}

/// Sizes of netloft_problem and netloft_members in the first versions of "netloft.solver/1" and
/// "netloft.strategy/1": up to the last function that they had in these versions.
inline constexpr std::size_t kFirstProblem = offsetof(netloft_problem, evaluate_both) + sizeof(void*),
                             kFirstMembers = offsetof(netloft_members, progress) + sizeof(void*);

}  // namespace netloft
