// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/assembler/pattern.hpp"
#include "framework/balance/factors.hpp"

#include <functional>

namespace netloft {

/// Values of the matrices of the linear motion M ÿ + C ẏ + K y = 0, with one sparsity pattern. Equation
/// numbers up to (8) in this header are those of growth.hpp and cayley.hpp.
struct LinearMotion {
  std::vector<double> K = {}, C = {}, M = {};  // [N/m], [N s/m], [kg]
  std::vector<double> convex = {};             // symmetric positive definite, an approximation of K [N/m]
  // Returns the change of K over the remaining Newton step, or an empty vector if the change is unknown.
  // Called only if a verdict depends on it.
  std::function<std::vector<double>()> K_error = {};
  bool is_damped = true;  // whether some element damps
};

/// A point near an equilibrium, over all dofs.
struct RestPlace {
  std::span<const double> x;
  std::span<const double> x_low = {};  // digits that rounding removes from x; empty: unknown
  std::span<const double> after = {};  // x after the remaining Newton step; empty: unknown
  std::span<const double> after_low = {};
  double fraction = 1;  // fraction of that step up to which points count as the same (kSamePlace)
};

/// Evaluates the matrices at a point and counts them in `cost`. Returns false if an element failed, which
/// Assembler::fault describes. All arguments must outlive `motion`, which may evaluate K_error later.
bool linearise(Assembler& assembler, const RestPlace& place, Statistics& cost, LinearMotion& motion);

/// Rounding error of a matrix that is assembled from many elements, relative to its largest entry.
inline constexpr double kRoundingOfMatrix = 1e-9;

/// Whether (9) holds; then the energy (8) of cayley.hpp never increases, and no disturbance grows:
///   M and K symmetric, K and M positive definite, C + Cᵀ positive semidefinite             (9)
/// Cholesky factorisations decide whether (9) holds; `factors` counts them. A positive definite K + Kᵀ would
/// not be enough: for M = 1 and K = [1 −b; b 1], s² = −1 ± ib, so that a motion grows for any b ≠ 0.
bool is_stable_by_energy(const SparsePattern& pattern, const LinearMotion& motion, Factors& factors);

/// Bound of |s| [1/s] for motions y exp(st) that grow with c = Re s/|s| of at least `fraction`; zero if none
/// can grow. With K = K₊ + N, m = y*My, d = y*Cy, k = y*K₊y and n = y*Ny (y* is the conjugate transpose), the
/// real part of (1) of growth.hpp, multiplied by y* and divided by s, is
///   Re s (m + k/|s|²) + Re d + Re(n/s) = 0,   m, k ≥ 0                                    (6a)
///   cm|s|² + Re d |s| ≤ |n|                                                               (6b)
///   |s| ≤ 2|n|/(Re d + ((Re d)² + 4cm|n|)^½)                                              (6c)
/// K₊, the stiffness of taut members, does not affect (6c). The result is the largest value of (6c) over all
/// unknowns. For the unknown i, |n|/m is at most the sum of its row of ½ (|N| + |Nᵀ|), relative to the masses
/// (Gershgorin), and Re d/m is the smaller eigenvalue of ½ (C + Cᵀ), relative to the masses, for a pair of i
/// with another unknown: the smallest of the pairs of one node, and of all pairs if that is negative.
///   |n|/m ≤ Σⱼ ½ (|Nᵢⱼ| + |Nⱼᵢ|) (mᵢmⱼ)^−½                                                 (6d)
///   Re d/m = ½ (a + d) − ((½ (a − d))² + b²)^½   for the pair [a b; b d]                  (6e)
/// An unknown without mass moves at the rate K/C.
double fastest_growth(const SparsePattern& pattern, const LinearMotion& motion, double fraction);

/// Calls visit(row, column, values[slot]…) for every entry of whole matrices of one pattern, symmetric or
/// not.
template <class Visit, class... Values>
void for_entries(const SparsePattern& p, Visit&& visit, const Values&... values) {
  for (std::int32_t c = 0; c < p.size; ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k) {
      const std::int32_t r = p.row[k];
      const std::size_t slot = p.slot_of(k);
      visit(r, c, values[slot]...);
      if (p.symmetric && r != c) visit(c, r, values[slot]...);
    }
}

}  // namespace netloft
