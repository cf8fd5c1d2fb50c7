// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/march_state.hpp"

#include "framework/assembler/assembler.hpp"

#include <algorithm>

namespace netloft {

MarchState state_at_rest(const Assembler& assembler, std::span<const double> u) {
  MarchState state;
  state.u.assign(static_cast<std::size_t>(assembler.pattern().size), 0.0);
  std::copy(u.begin(), u.end(), state.u.begin());
  state.v.assign(state.u.size(), 0.0);
  return state;
}

}  // namespace netloft
