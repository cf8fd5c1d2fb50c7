// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <span>
#include <vector>

namespace netloft::io {

/// What a sequence of meshes tends to, after L. F. Richardson, Phil. Trans. R. Soc. A 210, 1911:
///   f(h) = f* + C hᵖ                                                                        (1)
///   |f₃ − f₂|/|f₂ − f₁| = (h₃ᵖ − h₂ᵖ)/(h₂ᵖ − h₁ᵖ),   h₃ > h₂ > h₁    the observed order p   (2)
///   f* = f₁ + w (f₁ − f₂),   w = h₁ᵖ/(h₂ᵖ − h₁ᵖ)                                            (3)
/// h mesh widths, in any unit.

/// p of (2) from the sizes of the two differences; NaN unless both are positive and some p in (0, 20) fits.
double observed_order(double coarse_difference, double fine_difference, double h3, double h2, double h1);

/// w of (3).
double extrapolation_weight(double order, double h2, double h1);

/// Orders for which (1) is believed: less is no convergence to speak of, more is a coincidence of levels that
/// are too coarse, for no element here has an order above four.
bool is_credible(double order);

/// Orders observed one after the other on finer and finer levels, all credible and within a half of each
/// other.
bool is_steady(std::span<const double> orders);

/// What f on a sequence of meshes tends to, and how far one of them is from that.
struct Trend {
  double limit = std::numeric_limits<double>::quiet_NaN();  // f*
  double order = std::numeric_limits<double>::quiet_NaN();  // observed; NaN: assumed to be one
  bool steady = false;                                      // else `error` is a difference between levels
  double error = std::numeric_limits<double>::quiet_NaN();  // of the mesh that is asked about, > 0
};

/// `values` on meshes of widths `h`, in the order of falling widths; two or three are used, the finest ones.
/// Two give no order: one is assumed, which overstates the error of whatever converges faster. Levels that do
/// not converge steadily give no limit: the error is then the largest difference of mesh `asked` from
/// another.
Trend find_trend(const std::vector<double>& values, const std::vector<double>& h, std::size_t asked);

}  // namespace netloft::io
