// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace netloft::pictures {

/// The direction from which a gear is viewed: from port, from above, from ahead, or obliquely from above,
/// ahead and port.
enum class View { side, top, front, oblique };

/// The view "side", "top", "front" or "oblique"; nullopt for other names.
std::optional<View> view_of(const std::string& name);

/// The direction from the gear to the eye in a view: azimuth about z from x towards y, elevation above the
/// horizontal [degrees].
struct ViewAngles {
  double azimuth, elevation;
};
ViewAngles angles_of(View view);

using Point3 = std::array<double, 3>;

/// Parallel projection onto a picture with x to the right and y downwards, in pixels.
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

/// The projection that fits the points into the frame at the largest scale.
Projection fit(View view, const std::vector<Point3>& points, const Frame& frame);

}  // namespace netloft::pictures
