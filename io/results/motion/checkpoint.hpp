// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "io/results/motion/motion_watch.hpp"

#include <string>

namespace netloft::results {

/// The data from which an interrupted motion continues. Its further outputs and its report are then the same,
/// bit by bit, as without the interruption.
struct Checkpoint {
  MarchState state;
  MotionFindings findings;
};

/// Packs a checkpoint into bytes for a journal beside the output.
std::string pack_checkpoint(const MarchState& state, const MotionFindings& findings);

/// Restores a checkpoint, bit by bit, from its packed bytes. Throws FileError if they are not a packed
/// checkpoint.
Checkpoint unpack_checkpoint(const std::string& bytes);

}  // namespace netloft::results
