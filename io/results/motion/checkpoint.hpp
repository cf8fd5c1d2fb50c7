// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"

#include <string>

namespace netloft::results {

/// Packs the state from which a march continues into bytes for a journal beside the output.
std::string pack_checkpoint(const MarchState& state);

/// Restores the same state, bit by bit. Throws FileError if the bytes are not a packed state.
MarchState unpack_checkpoint(const std::string& bytes);

}  // namespace netloft::results
