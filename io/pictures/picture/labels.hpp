// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/view_projection.hpp"

#include <vector>

namespace netloft::pictures {

/// A line on the sheet, and how long the words are that belong beside it [pixels].
struct LabelledLine {
  Point3 from{}, to{};  // of which x and y count
  double words = 0;
};

/// Frames of the words beside lines, `size` high, in the order of the lines. Words are tried at seven places
/// along their line and on both sides of it, and moved into `picture` where they would run off it; the first
/// place is taken that is free of all words before it, else the one that shares least with them.
std::vector<Frame> place_labels(const std::vector<LabelledLine>& lines, double size, const Frame& picture);

}  // namespace netloft::pictures
