// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <span>
#include <vector>

namespace netloft::studies {

/// The limit of a sequence of meshes, after L. F. Richardson, Phil. Trans. R. Soc. A 210, 1911:
///   f(h) = f* + C hᵖ                                                                        (1)
///   |f₃ − f₂|/|f₂ − f₁| = (h₃ᵖ − h₂ᵖ)/(h₂ᵖ − h₁ᵖ),   h₃ > h₂ > h₁    the observed order p   (2)
///   f* = f₁ + w (f₁ − f₂),   w = h₁ᵖ/(h₂ᵖ − h₁ᵖ)                                            (3)
///   e = 1.25 |f − f*|                                      where similar meshes converge     (4)
///   e = 2 max(|f − f*|, |f − f* by p = 1 from f₃ and f₁|, |f − f_k|)    elsewhere         (5)
/// h are mesh widths in any unit. Meshes are similar if each cell of one is divided alike for the next: (1)
/// then holds as well as the order in (2) suggests. Gears of netting are triangulated anew for each mesh, and
/// the scatter between such meshes makes observed orders unreliable. There, e is the largest of three
/// differences: from the extrapolation with the observed order, if that is credible; from a first-order
/// extrapolation between the outer meshes, because gears of netting usually converge with first order and
/// scatter matters least there; and from the other meshes. 1.25 is the safety factor for three meshes of P.
/// J. Roache, Verification and Validation in Computational Science and Engineering, 1998, chapter 5; he and
/// L. Eça and M. Hoekstra, J. Comput. Phys. 262 (2014), use 3 without a credible order. 2 was chosen on gears
/// as the least round number for which 95 of 100 errors are within e (README.md).

/// The order p in (2) from the magnitudes of the two differences; NaN unless both are positive and some p in
/// (0, 20) satisfies (2).
double observed_order(double coarse_difference, double fine_difference, double h3, double h2, double h1);

/// The weight w in (3).
double extrapolation_weight(double order, double h2, double h1);

/// Whether (1) may be used with this order, 0.5 to 2.5. With a lower order there is hardly any convergence. A
/// higher one is a coincidence of levels, because no element here has an order above two.
bool is_credible(double order);

/// Whether the orders observed on successive levels are all credible and differ by at most a half.
bool is_steady(std::span<const double> orders);

/// The limit of f on a sequence of meshes, and the distance of one of them from it.
struct Trend {
  double limit = std::numeric_limits<double>::quiet_NaN();  // f*
  double order = std::numeric_limits<double>::quiet_NaN();  // observed; NaN: an order of one is assumed
  bool steady = false;                                      // whether the observed order is credible
  bool diverges = false;  // differences have one sign and grow, beyond kNoise of the value
  double error = std::numeric_limits<double>::quiet_NaN();  // e of the mesh `asked`, > 0
};

/// `values` belong to meshes of widths `h`, in the order of decreasing widths; the two or three finest are
/// used, and `asked` is one of them. Two meshes give no order, and an order of one is assumed. Meshes without
/// steady convergence give no limit. `similar`: whether the meshes are similar, see (4).
Trend find_trend(const std::vector<double>& values, const std::vector<double>& h, std::size_t asked,
                 bool similar = false);

}  // namespace netloft::studies
