// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"

#include <string>

namespace netloft::results {

/// Packs the state from which a motion can be resumed into bytes.
std::string pack_checkpoint(const MarchState& state);

/// Restores the packed state, bit by bit. Throws FileError if the bytes are not a packed state.
MarchState unpack_checkpoint(const std::string& bytes);

}  // namespace netloft::results
