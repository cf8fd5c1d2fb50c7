// SPDX-License-Identifier: BSD-3-Clause
//
// The keys of a scene that describe position and shape of parts, and functions that read them. Included only
// by files that read geometry.
#pragma once
#include "io/scenes/reading/geometry.hpp"

#include <cmath>
#include <optional>

namespace netloft::scenes {

inline constexpr std::int64_t kMostCells = 100000;  // limit of cells along one direction

using Point = std::array<double, 3>;

/// A value for each layout of a part.
template <class T>
struct ByLayout {
  T point, line, panel_in_triangles, panel_in_bars, body;

  const T& of(Layout layout) const {
    switch (layout) {
      case Layout::line:
        return line;
      case Layout::panel_in_triangles:
        return panel_in_triangles;
      case Layout::panel_in_bars:
        return panel_in_bars;
      case Layout::body:
        return body;
      default:
        return point;
    }
  }
};

extern const GeometryKey kAt, kLength, kBars, kLine, kAcross, kAlong, kBar, kNetting, kCells, kDivision,
    kSquareCells, kCorners, kFrom, kTo, kRadius, kRadiusAft, kOrigin, kPoints, kSide, kHeading, kHeel, kTrim,
    kTurns, kOutline, kRimEdge, kRimWidth, kRimHeight, kRimAt;

double read_real(formats::TableReader& table, const GeometryKey& key, std::optional<double> fallback = {});
/// Reads a word; returns the first allowed word if the key is missing.
std::string read_word(formats::TableReader& table, const GeometryKey& key);
/// Reads a required point; returns the origin after an error.
Point read_one_point(formats::TableReader& table, const GeometryKey& key);
/// Reads an array of integers, or a single integer if the key allows only one.
std::vector<std::int64_t> read_integers(formats::TableReader& table, const GeometryKey& key);
std::vector<Point> read_points(formats::TableReader& table, const GeometryKey& key);

inline double distance(const Point& a, const Point& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

inline Point between_points(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

inline void append(std::vector<double>& positions, const Point& p) {
  positions.insert(positions.end(), p.begin(), p.end());
}

}  // namespace netloft::scenes
