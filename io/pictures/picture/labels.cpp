// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::pictures {

namespace {

constexpr double kOff = 6;  // distance from the line, and from the edges of the picture [pixels]
// Distances of a label that is not directly beside its line [pixels].
constexpr std::array kFarOff = {26.0, 50.0, 80.0, 120.0, 170.0};

// The costs of a place for a label. A hidden pixel of the drawing costs 1; a label has about 2000 pixels.
constexpr double kOnLabel = 20;     // a pixel of another label
constexpr double kOnLine = 60;      // a pixel of the length of a line that runs through the label
constexpr double kCrossing = 200;   // a line that the leader crosses
constexpr double kAlong = 300;      // a leader that looks like a continuation of its line
constexpr double kPerPixel = 4;     // a pixel of distance from the line
constexpr double kOffMiddle = 60;   // per distance from the middle of the line, as a fraction of its length
constexpr double kLeastApart = 60;  // a leader, however short

/// The overlap of two labels [pixels²]. Each label has a margin, because labels that nearly touch look like
/// one label.
double shared(const Frame& a, const Frame& b) {
  constexpr double kApartAcross = 6, kApartDown = 3;
  const double across =
      std::min(a.left + a.width, b.left + b.width) - std::max(a.left, b.left) + kApartAcross;
  const double down = std::min(a.top + a.height, b.top + b.height) - std::max(a.top, b.top) + kApartDown;
  return across > 0 && down > 0 ? across * down : 0;
}

double within(double at, double lo, double hi) { return std::max(lo, std::min(at, hi)); }

using Stroke = std::array<Point3, 2>;

/// The length of the piece of a stroke that lies in a frame with a small margin [pixels]. The stroke is cut
/// at the four sides of the frame in turn.
double length_inside(const Stroke& stroke, const Frame& frame) {
  constexpr double kMargin = 2;
  const auto& [a, b] = stroke;
  const std::array<double, 2> low = {frame.left - kMargin, frame.top - kMargin};
  const std::array<double, 2> high = {frame.left + frame.width + kMargin, frame.top + frame.height + kMargin};
  double first = 0, last = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    const double d = b[k] - a[k];
    if (std::abs(d) < 1e-9) {
      if (a[k] < low[k] || a[k] > high[k]) return 0;
      continue;
    }
    const auto [enters, leaves] = std::minmax({(low[k] - a[k]) / d, (high[k] - a[k]) / d});
    first = std::max(first, enters);
    last = std::min(last, leaves);
  }
  return last > first ? (last - first) * std::hypot(b[0] - a[0], b[1] - a[1]) : 0;
}

double side_of(const Stroke& line, const Point3& p) {
  return (line[1][0] - line[0][0]) * (p[1] - line[0][1]) - (line[1][1] - line[0][1]) * (p[0] - line[0][0]);
}

/// Whether two strokes have nearly the same direction, so that one looks like a part of the other.
bool is_along(const Stroke& a, const Stroke& b) {
  const double ax = a[1][0] - a[0][0], ay = a[1][1] - a[0][1], bx = b[1][0] - b[0][0], by = b[1][1] - b[0][1];
  return std::abs(ax * by - ay * bx) < 0.4 * std::hypot(ax, ay) * std::hypot(bx, by);
}

bool cross(const Stroke& a, const Stroke& b) {
  return side_of(a, b[0]) * side_of(a, b[1]) < 0 && side_of(b, a[0]) * side_of(b, a[1]) < 0;
}

/// Finds places for labels one after the other.
class Labeller {
 public:
  Labeller(const std::vector<LabelledLine>& lines, double size, const Frame& picture, const Cover& cover)
      : size_(size), picture_(picture), cover_(cover) {
    for (const auto& line : lines) strokes_.push_back({line.from, line.to});
  }

  const LabelPlace& place(const LabelledLine& line) {
    LabelPlace best;
    double least = INFINITY;
    for (const double along : {0.5, 0.22, 0.78, 0.36, 0.64, 0.08, 0.92})
      for (const LabelPlace& place : places_at(line, along))
        if (const double cost = cost_of(place, {line.from, line.to}) + kOffMiddle * std::abs(along - 0.5);
            cost < least) {
          least = cost;
          best = place;
        }
    if (best.is_apart) strokes_.push_back({best.point, best.start_of_leader()});
    places_.push_back(best);
    return places_.back();
  }

 private:
  /// The places to the right, to the left, above and below a point of the line.
  std::vector<LabelPlace> places_at(const LabelledLine& line, double along) const {
    const Point3 at = {std::lerp(line.from[0], line.to[0], along),
                       std::lerp(line.from[1], line.to[1], along)};
    const double above = at[1] - kOff - size_, middle = at[0] - line.words / 2;
    std::vector<LabelPlace> places;
    const auto add = [&](double left, double top, bool is_apart) {
      places.push_back({in_picture({left, top, line.words, size_}), at, is_apart});
    };
    add(at[0] + kOff, above, false);
    add(at[0] - kOff - line.words, above, false);
    add(middle, above, false);
    add(middle, at[1] + kOff, false);
    for (const double off : kFarOff) {
      add(at[0] + off, at[1] - size_ / 2, true);
      add(at[0] - off - line.words, at[1] - size_ / 2, true);
      add(middle, at[1] - off - size_, true);
      add(middle, at[1] + off, true);
    }
    return places;
  }

  Frame in_picture(const Frame& f) const {
    return {within(f.left, picture_.left + kOff, picture_.left + picture_.width - kOff - f.width),
            within(f.top, picture_.top, picture_.top + picture_.height - f.height), f.width, f.height};
  }

  double cost_of(const LabelPlace& place, const Stroke& own) const {
    double cost = cover_ ? place.frame.width * place.frame.height * cover_(place.frame) : 0;
    for (const LabelPlace& other : places_) cost += kOnLabel * shared(place.frame, other.frame);
    for (const Stroke& stroke : strokes_) cost += kOnLine * length_inside(stroke, place.frame);
    return place.is_apart ? cost + cost_of_leader(place, own) : cost;
  }

  double cost_of_leader(const LabelPlace& place, const Stroke& own) const {
    const Stroke leader = {place.point, place.start_of_leader()};
    double cost =
        kLeastApart + kPerPixel * std::hypot(leader[1][0] - leader[0][0], leader[1][1] - leader[0][1]);
    for (const LabelPlace& other : places_) cost += kOnLine * length_inside(leader, other.frame);
    for (const Stroke& stroke : strokes_)
      if (stroke != own && cross(leader, stroke)) cost += kCrossing;
    if (is_along(leader, own)) cost += kAlong;
    return cost;
  }

  double size_;
  const Frame& picture_;
  const Cover& cover_;
  std::vector<Stroke> strokes_;  // lines and leaders
  std::vector<LabelPlace> places_;
};

}  // namespace

Point3 LabelPlace::start_of_leader() const {
  return {within(point[0], frame.left, frame.left + frame.width),
          within(point[1], frame.top, frame.top + frame.height)};
}

std::vector<LabelPlace> place_labels(const std::vector<LabelledLine>& lines, double size,
                                     const Frame& picture, const Cover& cover) {
  Labeller labeller(lines, size, picture, cover);
  std::vector<LabelPlace> places;
  for (const auto& line : lines) places.push_back(labeller.place(line));
  return places;
}

}  // namespace netloft::pictures
