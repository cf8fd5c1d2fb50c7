// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <algorithm>

namespace netloft {

/// Whether an unknown belongs to all elements of a part together, such as the front of a catch. A shared
/// unknown is no position and has no mass. Its equation contains no rates, so that it does not depend on the
/// past.
inline bool is_shared(const Assembler& assembler, std::size_t i) {
  if (assembler.is_place(i)) return false;
  const std::uint32_t node = assembler.numbering().node(Dof(i));
  return std::ranges::none_of(assembler.body_nodes(), [&](const auto& body) { return body[1] == node; });
}

}  // namespace netloft
