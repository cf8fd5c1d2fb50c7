// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/view_projection.hpp"

#include <functional>
#include <vector>

namespace netloft::pictures {

/// A line on the sheet that gets a label, and the length of the label [pixels].
struct LabelledLine {
  Point3 from{}, to{};  // only x and y are used
  double words = 0;
};

/// The place of a label, and the point of its line to which the label belongs. A label that stands apart from
/// its line needs a leader between its frame and that point.
struct LabelPlace {
  Frame frame;
  Point3 point;
  bool is_apart = false;

  /// The point of the frame that is nearest to the point of the line. A leader begins there.
  Point3 start_of_leader() const;
};

/// The fraction of a frame in which a label would hide something, 0 to 1.
using Cover = std::function<double(const Frame&)>;

/// Places for the labels of `lines`, `size` high, in the order of the lines. For each label, seven positions
/// along its line are tried, on four sides and at several distances; a place that would cross the edge is
/// moved into `picture`. The label gets the place where it hides as little as possible of earlier labels,
/// lines, leaders, and the drawing (`cover`).
std::vector<LabelPlace> place_labels(const std::vector<LabelledLine>& lines, double size,
                                     const Frame& picture, const Cover& cover = {});

}  // namespace netloft::pictures
