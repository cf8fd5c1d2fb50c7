// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/problem/factorisation.hpp"
#include "framework/problem/statistics.hpp"

namespace netloft {

/// The band (5) of growth that is not told from none, per power.
inline constexpr double kGrows = 1.01;

enum class GrowthVerdict { none, marginal, grows, unknown };

/// What a small disturbance does, and what it turns into.
struct Growth {
  GrowthVerdict verdict = GrowthVerdict::none;
  double per_power = 0;           // the largest |(3)| of what grows, over σ; zero where nothing does
  double rate = 0;                // of what grows [1/s]; without a unit, or zero, where nothing flows
  double frequency = 0;           // with which it swings, likewise [rad/s]; zero where it diverges
  std::vector<double> mode = {};  // over the unknowns, of length 1; empty where nothing could grow
  Statistics cost = {};           // what it took to know
  bool grows() const { return verdict == GrowthVerdict::grows; }
};

/// Stability of an equilibrium whose forces have no energy (drag, pressure), by its motion
///   M ẏ = −K y,   K = ∂r/∂x, the exact tangent                                            (1)
///   M = C/τ + G,   C = ∂r/∂ẋ,   τ = ε tr C / tr G;   M = G where tr C is not above 0                     (2)
/// C is the damping by the water that flows past, G the linear stiffness, which damps by the little ε what
/// no flow does; time counts in τ. y decays if every eigenvalue λ of K v = λ M v has Re λ > 0. A real λ < 0
/// (divergence) that det K < 0 tells of is there for any damping; whether a pair grows (flutter) depends on
/// it, of two unknowns with det K > 0 by the sign of K₁₁/M₁₁ + K₂₂/M₂₂: V. V. Bolotin, Nonconservative
/// Problems of the Theory of Elastic Stability, 1963. Netting waves in an oblique current as flags do, where
/// G alone would let it rest. Of C counts what damps: the block of a node, of a body with its rotation, loses
/// what of its symmetric part is negative, as that of a board beyond its greatest lift and of a sphere in its
/// drag crisis are. Without mass these would leave at once; with it they may swing where nothing else damps
/// them, which a motion tells. Mass and the damping of twines are left out: of 339 equilibria of trawls, of
/// 183 to 11 943 unknowns, masses with added ones changed no verdict; they lower what grows by a tenth.
///
/// The Cayley transform
///   A = (K + σM)⁻¹ (σM − K),  eigenvalues μ = (σ − λ)/(σ + λ)                             (3)
/// has one beyond the unit circle if and only if some Re λ < 0, best seen where |λ| is about σ: K. Meerbergen
/// and D. Roose, Matrix transformations for computing rightmost eigenvalues, IMA J. Numer. Anal. 16 (1996).
/// 24 steps of Arnoldi's find the outermost, for σ from the largest |K_ii|/M_ii, at least 1, by hundredths to
/// 1e-10. A Ritz value θ beyond the circle counts if it is known: the residual ρ of its pair and rounding,
/// over the cosine s of the angle between its left and right eigenvectors, leave it there,
///   (ρ + ε‖H‖)/s ≤ (|θ| − 1)/10                                                           (4)
/// (Y. Saad, Numerical Methods for Large Eigenvalue Problems, 2011, chapters 3 and 6). If it is not after 48
/// steps, A is far from normal (L. N. Trefethen and M. Embree, Spectra and Pseudospectra, 2005, chapter 16),
/// and its powers decide: growth that falls from one twenty of them to the next may pass.
///
/// What grows has Re λ < 0, with
///   |μ| = ((1 + c)/(1 − c))^½ at its largest, where σ = |λ|;   c = −Re λ/|λ|              (5)
/// It is marginal, not told from none, if |μ| ≤ kGrows: a pair then decays or grows by less than 6 % in a
/// swing, as a hundredth of the damping decides, of which (2) is not that sure; or if powers have not
/// settled; or if rounding of K, or what the imbalance f changes in it over a length l, would undo it:
///   |λ| ‖Mv‖ ≤ ‖10 ε |K||v| + (f/l) |v|‖                                                  (6)
///
/// Nothing grows if M is symmetric and positive definite, and so is the symmetric part of K, for
///   Re λ = v*(K + Kᵀ)v / 2v*Mv:                                                           (7)
/// two Cholesky factorisations, which are tried first. Unknown where K + σM could not be factorised. There is
/// no chance in it, and no clock: the same equilibrium has the same verdict.
///
/// `x_low`: what x rounds off, if it is known. `doubt` is f/l of (6) [N/m].
Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make,
                   std::span<const double> x_low = {}, double doubt = 0);
Growth find_growth(const SparsePattern& pattern, std::span<const double> K, std::span<const double> M,
                   const MakeFactorisation& make, double doubt = 0);

}  // namespace netloft
