// SPDX-License-Identifier: BSD-3-Clause
//
// Converts the motion of a FEMNET gear: its waves, and the keys of the table [analysis].
#pragma once
#include "io/scenes/import/femnet_gear.hpp"

namespace netloft::scenes::femnet {

/// The reason why linear waves cannot represent the waves of a file; empty if they can.
std::string fault_of_waves(const Environment& e);

/// The key `waves` of [water]: Airy waves, as in FEMNET's first wave model.
std::string waves_text(const Environment& e);

/// The height by which crests of second-order waves exceed those of linear waves [m]:
///   a² k (3 − tanh² k h)/(4 tanh³ k h)
/// The waves have the amplitude a [m] and the wave number k [1/m], in water of the depth h [m].
double rise_of_second_order(const Environment& e);

/// The table [analysis] of a motion that begins at rest and lasts as long as the motion in the file.
std::string motion_text(const Environment& e);

}  // namespace netloft::scenes::femnet
