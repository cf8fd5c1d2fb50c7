// SPDX-License-Identifier: BSD-3-Clause
//
// What a gear of FEMNET needs to move: its waves, and how the motion is gone through.
#pragma once
#include "io/scenes/import/femnet_gear.hpp"

namespace netloft::scenes::femnet {

/// Why linear waves do not do for those of a file; empty if they do.
std::string fault_of_waves(const Environment& e);

/// The key `waves` of [water]: Airy's, as FEMNET has them of its first model.
std::string waves_text(const Environment& e);

/// How far the crests of waves of the second order stand above those of linear ones [m], in still water:
///   a² k (3 − tanh² k h)/(4 tanh³ k h)
double rise_of_second_order(const Environment& e);

/// [analysis] of a motion that begins at rest and ends where the file says.
std::string motion_text(const Environment& e);

}  // namespace netloft::scenes::femnet
