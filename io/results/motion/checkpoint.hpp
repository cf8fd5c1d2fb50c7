// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "io/results/motion/motion_watch.hpp"

#include <string>

namespace netloft::results {

/// The data that an interrupted motion needs to continue such that its further outputs and its report are the
/// same, bit by bit, as without the interruption.
struct Checkpoint {
  MarchState state;
  MotionFindings findings;
};

/// Packs a checkpoint into bytes for a journal beside the output.
std::string pack_checkpoint(const MarchState& state, const MotionFindings& findings);

/// Restores the same checkpoint, bit by bit. Throws FileError if the bytes are not a packed checkpoint.
Checkpoint unpack_checkpoint(const std::string& bytes);

}  // namespace netloft::results
