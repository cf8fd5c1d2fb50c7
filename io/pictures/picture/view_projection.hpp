// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace netloft::pictures {

/// The direction from which a gear is seen: from port, from above, from ahead, from above and ahead on the
/// port side.
enum class View { side, top, front, oblique };

/// "side", "top", "front", "oblique"; nothing for other names.
std::optional<View> view_of(const std::string& name);

/// The direction of the eye of a view: azimuth about z from x towards y, elevation above the level [degrees].
struct ViewAngles {
  double azimuth, elevation;
};
ViewAngles angles_of(View view);

using Point3 = std::array<double, 3>;

/// Parallel projection onto a picture, x to the right and y downwards in pixels.
struct Projection {
  Point3 right, up, eye;  // unit vectors
  double pixels_per_metre = 1, x = 0, y = 0;

  /// x, y on the picture, and the distance towards the eye [m].
  Point3 operator()(const Point3& p) const;
};

/// A rectangle of the picture.
struct Frame {
  double left, top, width, height;
};

/// The projection that puts the points into the frame, as large as it may be.
Projection fit(View view, const std::vector<Point3>& points, const Frame& frame);

}  // namespace netloft::pictures
