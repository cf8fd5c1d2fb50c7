// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/view_projection.hpp"

#include "io/formats/units/degrees.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>

namespace netloft::pictures {

namespace {

Projection axes_of(const ViewAngles& angles) {
  const double a = formats::in_radians(angles.azimuth), e = formats::in_radians(angles.elevation);
  const double ca = std::cos(a), sa = std::sin(a), ce = std::cos(e), se = std::sin(e);
  return {{-sa, ca, 0}, {-se * ca, -se * sa, ce}, {ce * ca, ce * sa, se}};
}

}  // namespace

ViewAngles angles_of(View view) {
  switch (view) {
    case View::side:
      return {-90, 0};
    case View::top:
      return {-90, 90};
    case View::front:
      return {180, 0};
    default:
      return {-140, 25};
  }
}

std::optional<View> view_of(const std::string& name) {
  if (name == "side") return View::side;
  if (name == "top") return View::top;
  if (name == "front") return View::front;
  if (name == "oblique") return View::oblique;
  return {};
}

Point3 Projection::operator()(const Point3& p) const {
  return {x + pixels_per_metre * dot(p, right), y - pixels_per_metre * dot(p, up), dot(p, eye)};
}

Projection fit(View view, const std::vector<Point3>& points, const Frame& frame) {
  Projection projection = axes_of(angles_of(view));
  double left = 0, right = 1, low = 0, high = 1;
  if (!points.empty()) {
    left = low = INFINITY;
    right = high = -INFINITY;
  }
  for (const auto& p : points) {
    left = std::min(left, dot(p, projection.right));
    right = std::max(right, dot(p, projection.right));
    low = std::min(low, dot(p, projection.up));
    high = std::max(high, dot(p, projection.up));
  }
  projection.pixels_per_metre =
      std::min(frame.width / std::max(right - left, 1e-6), frame.height / std::max(high - low, 1e-6));
  projection.x = frame.left + frame.width / 2 - projection.pixels_per_metre * (left + right) / 2;
  projection.y = frame.top + frame.height / 2 + projection.pixels_per_metre * (low + high) / 2;
  return projection;
}

}  // namespace netloft::pictures
