// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

namespace netloft::sample {

/// The hanging panel of the trawl-gear paper, fig. 6a: 40 x 40 meshes with bars of 0.6 m in n x n cells, the
/// top row held over 32 m, from a flat sketch of the given height [m]. The diagonals of the cells alternate.
Scene hanging_panel(int n, double height);

/// A rope of 100 m in n bars between (0, 0, 0) and (80, 0, -20).
Scene hanging_rope(int n);

}  // namespace netloft::sample
