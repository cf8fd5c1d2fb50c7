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
///   e = 1.25 |f − f*|                                           if similar meshes converge  (4)
///   e = 2 max(|f − f*|, |f − f°|, |f − f_k|)                                     elsewhere  (5)
/// f is a number computed on a mesh of width h (in any unit), f* its limit for h → 0, p the order of
/// convergence. f₁, f₂, f₃ are the values on three meshes, f₁ on the finest, and f_k any of them. e estimates
/// the error of f on a mesh that the caller names. If p is credible, (4) holds for similar meshes, each of
/// which divides the cells of the next coarser one evenly. Gears of netting are triangulated anew for each
/// mesh, and the scatter between such meshes makes observed orders unreliable. For such meshes (5) takes the
/// largest of three differences: from the limit (3), if p is credible; from f°, the limit with p = 1 from f₃
/// and f₁, because gears usually converge with first order; and from the values f_k on the other meshes. The
/// safety factor 1.25 for three meshes is from P. J. Roache, Verification and Validation in Computational
/// Science and Engineering, 1998, chapter 5. For an order that is not credible, Roache uses a factor of 3,
/// and so do L. Eça and M. Hoekstra, J. Comput. Phys. 262 (2014). The factor 2 is the smallest whole number
/// for which 95 of 100 errors of gears are within e (tests/bench/error_bars.md).

/// The order p of (2), from the magnitudes of the differences f₃ − f₂ and f₂ − f₁; NaN unless both are
/// positive and some p in (0, 20) satisfies (2).
double observed_order(double coarse_difference, double fine_difference, double h3, double h2, double h1);

/// The weight w in (3).
double extrapolation_weight(double order, double h2, double h1);

/// Whether (1) may be used with this order, from 0.5 to 2.5. With a lower order, meshes do not converge well
/// enough. A higher order is a coincidence, because no element has an order above two.
bool is_credible(double order);

/// Whether the orders observed on successive levels are all credible and differ by at most a half.
bool is_steady(std::span<const double> orders);

/// The limit of f on a sequence of meshes, and the error of f on one of these meshes.
struct Trend {
  double limit = std::numeric_limits<double>::quiet_NaN();  // the limit f*
  // Order of convergence; NaN if an order of one is assumed.
  double order = std::numeric_limits<double>::quiet_NaN();
  bool steady = false;    // whether `order` is credible
  bool diverges = false;  // whether values drift in one direction and do not converge
  double error = std::numeric_limits<double>::quiet_NaN();  // error estimate e on the mesh `asked`, > 0
};

/// `values` of f belong to meshes of widths `h`, in the order of decreasing widths; the two or three finest
/// meshes are used, and the error is estimated for the mesh with index `asked`. With two meshes, an order of
/// one is assumed. Without steady convergence, there is no limit. `similar`: whether the meshes are similar,
/// as (4) requires.
Trend find_trend(const std::vector<double>& values, const std::vector<double>& h, std::size_t asked,
                 bool similar = false);

}  // namespace netloft::studies
