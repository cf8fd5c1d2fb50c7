// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"

#include <string>

namespace netloft::results {

/// The state from which a march continues, as bytes in a journal beside the output.
std::string pack_checkpoint(const MarchState& state);

/// The same state, to the bit. Throws FileError if the bytes are none.
MarchState unpack_checkpoint(const std::string& bytes);

}  // namespace netloft::results
