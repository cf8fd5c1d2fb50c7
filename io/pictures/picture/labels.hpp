// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/view_projection.hpp"

#include <vector>

namespace netloft::pictures {

/// A line on the sheet that gets a label, and the length of the label [pixels].
struct LabelledLine {
  Point3 from{}, to{};  // only x and y are used
  double words = 0;
};

/// Frames of the labels beside lines, `size` high, in the order of the lines. Each label is tried at seven
/// positions along its line, on both sides, and is moved into `picture` if it would cross the edge. It gets
/// the first position that overlaps no earlier label, else the position with the least overlap.
std::vector<Frame> place_labels(const std::vector<LabelledLine>& lines, double size, const Frame& picture);

}  // namespace netloft::pictures
