// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/problem/factorisation.hpp"

namespace netloft {

/// Growth below this is not told from none.
inline constexpr double kGrows = 1.01;

/// What a small disturbance does, and what it turns into.
struct Growth {
  double per_power = 0;      // of C, see find_growth
  std::vector<double> mode;  // over the unknowns, of length 1; empty where nothing could grow
  bool grows() const { return per_power > kGrows; }
};

/// Stability of an equilibrium whose forces have no energy (drag, pressure), by the motion
///   M ẏ = −K y,  K the exact tangent, M the linear stiffness                           (1)
/// in which y decays if every eigenvalue λ of K v = λ M v has Re λ > 0. The Cayley transform
///   C = (K + σM)⁻¹ (σM − K),  eigenvalues (σ − λ)/(σ + λ)                              (2)
/// has one beyond the unit circle if and only if some Re λ < 0, best seen where |λ| is about σ: powers of C
/// for σ = 1, 0.1, … 1e-8 find it. C is not normal: where growth is seen, powers go on while it falls, for
/// it may pass (L. N. Trefethen and M. Embree, Spectra and Pseudospectra, 2005, chapter 16). Where K is
/// symmetric this is the sign of its least eigenvalue. Source of (2): K. Meerbergen and D. Roose, Matrix
/// transformations for computing rightmost eigenvalues, IMA J. Numer. Anal. 16 (1996).
///
/// None has if the symmetric part of K is positive definite, for Re λ = v*(K + Kᵀ)v / 2v*Mv:     (3)
/// one Cholesky factorisation, which is tried first.
///
/// Returns the largest growth found, per power of C, up to the first beyond kGrows, which is unstable; zero
/// by (3). No number where K + σM could not be factorised.
Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make);
Growth find_growth(const SparsePattern& pattern, std::span<const double> K, std::span<const double> M,
                   const MakeFactorisation& make);

}  // namespace netloft
