// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace netloft::results {

/// The values of colours: from `lo` to `hi`, linearly or logarithmically.
struct Scale {
  double lo = 0, hi = 1;
  bool is_logarithmic = false;
  bool is_cut_below = false, is_cut_above = false;  // there are values beyond its ends

  /// From 0 at `lo` to 1 at `hi`, not beyond.
  double place(double value) const;
  double value(double place) const;
  /// Round values for a legend.
  std::vector<double> ticks() const;
};

/// The range of the values of a field in all states, so that a colour means the same in each.
class FieldSpread {
 public:
  void take(std::span<const double> values);
  bool is_known() const { return !sample_.empty(); }

  /// A linear scale of all values; with `middle` one that leaves out the fiftieth at either end: tensions at
  /// single corners of netting grow with every finer mesh, and would take up most of the colours. It begins
  /// at zero where that costs less than half of it.
  Scale linear(bool middle) const;
  /// A logarithmic one of the same values, over four decades at most; linear where nothing is above zero.
  Scale logarithmic(bool middle) const;

 private:
  struct Ends {
    double lo, hi, low, high;  // of all values; of those that are not left out
  };
  Ends ends(bool middle) const;
  double lo_ = INFINITY, hi_ = -INFINITY;
  std::vector<double> sample_;
};

/// Ranges and scales of a field for netting, for ropes and for single nodes: tensions of twines and of ropes
/// differ by a factor of a hundred.
using FieldSpreads = std::array<FieldSpread, kCellKinds>;
using FieldScales = std::array<std::optional<Scale>, kCellKinds>;

FieldSpreads spreads_of(const StoredShape& stored, const std::string& field);
/// Nothing for a kind of cells without values.
FieldScales scales_of(const FieldSpreads& spreads, bool is_logarithmic);

/// Values at the corners of triangles: means over the triangles of a part that share the node. A field is
/// constant in each triangle; where some are slack and their neighbours taut, the mean is what the netting
/// bears. NaN where the triangle itself has no value.
std::vector<std::array<double, 3>> values_at_corners(const StoredMesh& mesh,
                                                     const std::vector<double>& by_cell);

}  // namespace netloft::results
