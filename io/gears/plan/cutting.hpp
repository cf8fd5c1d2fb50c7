// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::gears {

/// A cutting rate: the knots and bars that are cut in turn along a slanting side of netting (ISO 1532; FAO,
/// Fisherman's Workbook, 1990, "cutting rates"). One cycle of b bars (B), n points (N or P) and t meshes
/// (M or T) goes
///   across   a = b/2 + t   meshes      (1)
///   deep     d = b/2 + n   meshes      (2)
/// A bar goes half a mesh across and half a mesh deep, a point goes one mesh deep, and a mesh goes one mesh
/// across. 5B1P goes 2.5 meshes across in 3.5 meshes deep, 3B1M goes 2.5 across in 1.5 deep. Half meshes are
/// counted as integers, so that cycles add up exactly.
struct CuttingRate {
  int bars = 0, points = 0, meshes = 0;

  int half_meshes_across() const { return bars + 2 * meshes; }  // (1)
  int half_meshes_deep() const { return bars + 2 * points; }    // (2)
  bool is_straight() const { return half_meshes_across() == 0; }
  /// Number of meshes across in `deep` meshes aft; undefined for a rate that only goes across (AM).
  double across(double deep) const { return deep * half_meshes_across() / half_meshes_deep(); }
  double deep(double across) const { return across * half_meshes_deep() / half_meshes_across(); }

  bool operator==(const CuttingRate&) const = default;
};

/// Parses a rate such as "5B1P", "1N2B", "AB", "AN" or "AM". N means the same as P, and T the same as M.
/// Returns nullopt if the text is not a rate.
std::optional<CuttingRate> parse_rate(std::string_view text);

/// For a text that is not a rate: rates that differ from it in one letter, as proposals.
std::vector<std::string> rates_near(const std::string& text);

}  // namespace netloft::gears
