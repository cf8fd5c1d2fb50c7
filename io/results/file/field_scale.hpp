// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace netloft::results {

/// Maps values to colours, linearly or logarithmically, from `lo` to `hi`.
struct Scale {
  double lo = 0, hi = 1;
  bool is_logarithmic = false;
  bool is_cut_below = false, is_cut_above = false;  // whether some values are below lo, above hi

  /// The position of a value in the colour map, 0 at `lo` and 1 at `hi`, clamped to this range.
  double place(double value) const;
  double value(double place) const;
  /// Round values for a legend.
  std::vector<double> ticks() const;
};

/// The range of a field's values over all states, so that a colour has the same meaning in each state.
class FieldSpread {
 public:
  void take(std::span<const double> values);
  bool is_known() const { return !sample_.empty(); }

  /// Returns a linear scale of all values. With `middle`, the scale leaves out the largest and the smallest
  /// fiftieth of the values: tensions at single corners of netting grow with every refinement of the mesh and
  /// would use up most colours. If all values are positive and begin in the lower half of the scale, the
  /// scale begins at zero.
  Scale linear(bool middle) const;
  /// Returns a logarithmic scale of the values that linear() would use, over at most four decades; a linear
  /// scale if no value is positive.
  Scale logarithmic(bool middle) const;

 private:
  struct Ends {
    double lo, hi, low, high;  // lo, hi: range of all values; low, high: of the middle values
  };
  Ends ends(bool middle) const;
  double lo_ = INFINITY, hi_ = -INFINITY;
  std::vector<double> sample_;
};

/// Ranges and scales of a field. Netting, ropes and single nodes have separate ones, because tensions of
/// ropes are a hundred times larger than tensions of twines.
using FieldSpreads = std::array<FieldSpread, kCellKinds>;
using FieldScales = std::array<std::optional<Scale>, kCellKinds>;

FieldSpreads spreads_of(const StoredShape& stored, const std::string& field);
/// The scales of a field: one for each kind of cells that has values.
FieldScales scales_of(const FieldSpreads& spreads, bool is_logarithmic);

/// Values at the corners of triangles: each is the mean over the triangles of the part that share the corner.
/// A field is constant within a triangle, and taut and slack triangles may alternate, so that only means show
/// the load of the netting. NaN if the triangle itself has no value.
std::vector<std::array<double, 3>> values_at_corners(const StoredMesh& mesh,
                                                     const std::vector<double>& by_cell);

}  // namespace netloft::results
