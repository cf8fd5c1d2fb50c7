// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/linear_motion.hpp"

namespace netloft {

/// The band (6) of growth that is not told from none, per power.
inline constexpr double kGrows = 1.01;
/// Least frequency over rate of what swings: a pair that turns more slowly grows by exp(10 π) in half a turn,
/// from what a double rounds off to the size of the gear, so that it never comes round.
inline constexpr double kSwings = 0.1;

enum class GrowthVerdict { none, marginal, grows, unknown };

/// What a small disturbance does, and what it turns into.
struct Growth {
  GrowthVerdict verdict = GrowthVerdict::none;
  double per_power = 0;                 // the largest |(4)| of what grows, over σ; zero where nothing does
  double rate = 0;                      // Re s of what grows [1/s]
  double frequency = 0;                 // Im s, with which it swings [rad/s]; zero where it diverges
  std::vector<double> mode = {};        // over the unknowns, of length 1; empty where nothing could grow
  std::vector<double> mode_later = {};  // a quarter of a period later, on the same scale; empty: no period
  Statistics cost = {};                 // what it took to know
  bool grows() const { return verdict == GrowthVerdict::grows; }
  /// Flutter and not divergence: a pair, which goes round and comes to rest nowhere near.
  bool swings() const { return frequency > kSwings * rate; }
};

/// Stability of an equilibrium whose forces have no energy (drag, pressure), by its linear motion
///   M ÿ + C ẏ + K y = 0,   M = ∂r/∂ẍ,   C = ∂r/∂ẋ,   K = ∂r/∂x                            (1)
/// with all masses and added masses, the damping of the water that flows past and the losses of the material.
/// C keeps its sign: boards beyond their greatest lift and spheres in their drag crisis drive a motion. y
/// decays if every s of (s²M + sC + K) y = 0 has Re s < 0. A real s > 0 (divergence) that det K < 0 tells of
/// is there whatever M and C are; whether a pair grows (flutter) depends on both: V. V. Bolotin,
/// Nonconservative Problems of the Theory of Elastic Stability, 1963. Unknowns with neither mass nor damping
/// follow at once: they get
///   C = τ G,   G the linear stiffness,   τ = 1 ms                                          (2)
///
/// One step of the trapezoidal rule over 2/σ is the Cayley transform of (1), by one factorisation:
///   (K + σC + σ²M) d = 2 (σM v − K y),   y ← y + d,   v ← σ d − v,   v = ẏ                 (3)
///   A: (y, v) → (y, v),   eigenvalues μ = (σ + s)/(σ − s)                                  (4)
/// It has one beyond the unit circle if and only if some Re s > 0, best seen where |s| is about σ: K.
/// Meerbergen and D. Roose, Matrix transformations for computing rightmost eigenvalues, IMA J. Numer. Anal.
/// 16 (1996). 24 steps of Arnoldi's find the outermost, for σ from 1e-3/s by hundredths up to the fastest
/// that may grow, by (6c). A Ritz value θ beyond the circle counts if it is known: the residual ρ that A
/// leaves of its pair, over the cosine χ of the angle between its left and right eigenvectors, leaves it
/// there,
///   ρ/χ ≤ (|θ| − 1)/10                                                                    (5)
/// (Y. Saad, Numerical Methods for Large Eigenvalue Problems, 2011, chapters 3 and 6). If it is not after 48
/// steps, A is far from normal (L. N. Trefethen and M. Embree, Spectra and Pseudospectra, 2005, chapter 16),
/// and its powers decide: growth that falls from 24 of them to the next may pass. What is slower than σ/10 is
/// left to the smaller σ: with masses of 1, w = σy and all ω ≪ σ, A is next to
///   (w, v) → (w + 2v, v − 2Kw/σ²),   μ = 1 ± 2iω/σ,                                       (5a)
/// but zᵀAz of unit vectors goes from 0 to 2. Ritz values may lie anywhere between, and (5) of them be small.
///
/// What grows has Re s > 0, with
///   |μ| = ((1 + c)/(1 − c))^½ at its largest, where σ = |s|;   c = Re s/|s|                (6)
/// and what is fast does not grow. With K = K₊ + N, m = y*My, d = y*Cy, k = y*K₊y and n = y*Ny the real part
/// of (1) over s is
///   Re s (m + k/|s|²) + Re d + Re(n/s) = 0,   m, k ≥ 0                                    (6a)
///   c|s|m ≤ −Re d + |n|/|s|                                                               (6b)
///   |s| ≤ max(−Re d, 0)/(cm) + (|n|/(cm))^½                                               (6c)
/// whatever K₊, the stiffness of taut members, and a C that damps. Every unknown alone gives an estimate of
/// (6c), which may be ten times too small, as far as the greatest σ sees. One without mass follows K by C.
/// What grows is marginal, not told from none, if |μ| ≤ kGrows: a pair then decays or grows by less than 6 %
/// in a swing, as a hundredth of the damping decides; if it swings where nothing damps, in still water
/// without losses: a little damping may stop it or not (Bolotin), and water, which resists with the square of
/// the speed, stops it at an amplitude that falls with its rate; if powers have not settled; or if rounding
/// of K would undo it; or, of what diverges, what K changes by over the Newton step δ that is left, no
/// farther than one place reaches (kSamePlace), for along a soft mode a small imbalance leaves a long step:
///   ‖(s²M + sC) y‖ ≤ ‖10 ε |K||y|‖   or   0 < yᵀ(s²M + sC) y ≤ yᵀ(K(x + δ) − K(x)) y       (7)
///
/// Lengths are those of an energy,
///   ‖(y, v)‖² = yᵀ(K₊ + σ²M) y + vᵀM v,   K₊ the convex part of K                          (8)
/// in which A enlarges nothing where K is K₊, and C damps; in others what passes looks like growth. Nothing
/// grows where this energy falls:
///   M and K symmetric, K and M positive definite, C + Cᵀ positive semidefinite             (9)
/// by Cholesky factorisations, which are tried first. (That K + Kᵀ is positive definite is not enough: s² =
/// −1 ± ib of K = [1 −b; b 1] grows for any b.) Unknown where K + σC + σ²M could not be factorised. There is
/// no chance in it, and no clock: the same equilibrium has the same verdict.
Growth find_growth(Assembler& assembler, const RestPlace& place, const MakeFactorisation& make);
Growth find_growth(const SparsePattern& pattern, const LinearMotion& motion, const MakeFactorisation& make);

}  // namespace netloft
