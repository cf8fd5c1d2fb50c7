// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/problem/factorisation.hpp"

namespace netloft {

/// Growth below this is not told from none.
inline constexpr double kGrows = 1.01;

/// What a small disturbance does, and what it turns into.
struct Growth {
  double per_power = 0;           // of the matrix (3), see find_growth
  double rate = 0;                // of what grows [1/s]; without a unit, or zero, where nothing flows
  double frequency = 0;           // with which it swings, likewise [rad/s]; zero where it diverges
  std::vector<double> mode = {};  // over the unknowns, of length 1; empty where nothing could grow
  bool grows() const { return per_power > kGrows; }
};

/// Stability of an equilibrium whose forces have no energy (drag, pressure), by its motion
///   M ẏ = −K y,   K = ∂r/∂x, the exact tangent                                            (1)
///   M = C/τ + G,   C = ∂r/∂ẋ,   τ = ε tr C / tr G;   M = G where tr C is not above 0                     (2)
/// C is the damping by the water that flows past, G the linear stiffness, which damps by the little ε what
/// no flow does; time counts in τ. y decays if every eigenvalue λ of K v = λ M v has Re λ > 0. A real λ < 0
/// (divergence) that det K < 0 tells of is there for any damping; whether a pair grows (flutter) depends on
/// it, of two unknowns with det K > 0 by the sign of K₁₁/M₁₁ + K₂₂/M₂₂: V. V. Bolotin, Nonconservative
/// Problems of the Theory of Elastic Stability, 1963. Netting waves in an oblique current as flags do, where
/// G alone would let it rest. Mass and the damping of twines are left out: of 339 equilibria of trawls, of
/// 183 to 11 943 unknowns, masses with added ones changed no verdict; they lower what grows by a tenth.
///
/// The Cayley transform
///   (K + σM)⁻¹ (σM − K),  eigenvalues (σ − λ)/(σ + λ)                                     (3)
/// has one beyond the unit circle if and only if some Re λ < 0, best seen where |λ| is about σ: its powers
/// for σ from the largest |K_ii|/M_ii, at least 1, by tenths to 1e-10 find it. It is not normal: where growth
/// is seen, powers go on while it falls, for it may pass (L. N. Trefethen and M. Embree, Spectra and
/// Pseudospectra, 2005, chapter 16). Where K is symmetric this is the sign of its least eigenvalue. Source of
/// (3): K. Meerbergen and D. Roose, Matrix transformations for computing rightmost eigenvalues, IMA J. Numer.
/// Anal. 16 (1996).
///
/// None has if M is symmetric and positive definite, and so is the symmetric part of K, for
///   Re λ = v*(K + Kᵀ)v / 2v*Mv:                                                           (4)
/// two Cholesky factorisations, which are tried first.
///
/// Returns the largest growth found, per power of (3), up to the first beyond kGrows, which is unstable; zero
/// by (4). No number where K + σM could not be factorised. `x_low`: what x rounds off, if it is known.
Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make,
                   std::span<const double> x_low = {});
Growth find_growth(const SparsePattern& pattern, std::span<const double> K, std::span<const double> M,
                   const MakeFactorisation& make);

}  // namespace netloft
