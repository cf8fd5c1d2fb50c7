// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <span>
#include <vector>

namespace netloft::io {

/// The limit of a sequence of meshes, after L. F. Richardson, Phil. Trans. R. Soc. A 210, 1911:
///   f(h) = f* + C hᵖ                                                                        (1)
///   |f₃ − f₂|/|f₂ − f₁| = (h₃ᵖ − h₂ᵖ)/(h₂ᵖ − h₁ᵖ),   h₃ > h₂ > h₁    the observed order p   (2)
///   f* = f₁ + w (f₁ − f₂),   w = h₁ᵖ/(h₂ᵖ − h₁ᵖ)                                            (3)
/// h mesh widths, in any unit.

/// The order p in (2) from the magnitudes of the two differences; NaN unless both are positive and some p in
/// (0, 20) satisfies (2).
double observed_order(double coarse_difference, double fine_difference, double h3, double h2, double h1);

/// The weight w in (3).
double extrapolation_weight(double order, double h2, double h1);

/// Whether (1) may be used with this order. A lower order is no convergence to speak of. A higher one is a
/// coincidence of levels that are too coarse, because no element here has an order above four.
bool is_credible(double order);

/// Whether orders observed on successively finer levels are all credible and differ by a half at most.
bool is_steady(std::span<const double> orders);

/// The limit of f on a sequence of meshes, and the distance of one of them from it.
struct Trend {
  double limit = std::numeric_limits<double>::quiet_NaN();  // f*
  double order = std::numeric_limits<double>::quiet_NaN();  // observed; NaN: an order of one is assumed
  bool steady = false;                                      // false: `error` is a difference between levels
  double error = std::numeric_limits<double>::quiet_NaN();  // of the mesh `asked`, > 0
};

/// `values` belong to meshes of widths `h`, in the order of decreasing widths; the two or three finest are
/// used. Two meshes give no order: one is assumed, which overstates the error of whatever converges faster.
/// Meshes that do not converge steadily give no limit: the error is then the largest difference of mesh
/// `asked` from another one.
Trend find_trend(const std::vector<double>& values, const std::vector<double>& h, std::size_t asked);

}  // namespace netloft::io
