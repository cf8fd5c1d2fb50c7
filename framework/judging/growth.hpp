// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/linear_motion.hpp"

namespace netloft {

/// Growth factors per step up to this value cannot be distinguished from 1 (no growth); see (6) below.
inline constexpr double kMarginalGrowth = 1.01;
/// A growing motion oscillates if its angular frequency exceeds this multiple of its growth rate. Otherwise
/// it grows by at least exp(10 π) in half a period, that is, from a rounding error to the size of the gear,
/// and never completes a period.
inline constexpr double kOscillates = 0.1;

enum class GrowthVerdict { none, marginal, grows, unknown };

/// Growth of a small disturbance, and the motion into which it develops.
struct Growth {
  GrowthVerdict verdict = GrowthVerdict::none;
  double per_power = 0;           // largest growth factor |μ| of (6) for any σ; zero if nothing grows
  double rate = 0;                // growth rate Re s of the growing motion [1/s]
  double frequency = 0;           // angular frequency Im s of this motion [rad/s]; zero for a divergence
  std::vector<double> mode = {};  // shape over the unknowns, of length 1; empty if nothing grows
  // The mode a quarter of a period later, on the same scale; empty if the motion does not oscillate.
  std::vector<double> mode_later = {};
  double share = 1;       // fraction of the gear's mass that the motion moves (extent.hpp)
  bool is_local = false;  // whether the motion moves a negligible part of the gear, and nothing else grows
  bool grows() const { return verdict == GrowthVerdict::grows; }
  /// Whether the growth is flutter (a growing oscillation, from a pair of complex eigenvalues), not
  /// divergence.
  bool swings() const { return frequency > kOscillates * rate; }
};

/// Stability of an equilibrium whose forces have no potential (drag, pressure), by its linear motion
///   M ÿ + C ẏ + K y = 0,   M = ∂r/∂ẍ,   C = ∂r/∂ẋ,   K = ∂r/∂x                            (1)
/// with all masses and added masses, the damping by the flow and the losses of the material. C may drive a
/// motion, for instance of boards beyond their greatest lift or of spheres in their drag crisis. y decays if
/// (s²M + sC + K) y = 0 has only solutions with Re s < 0. A real s > 0 (divergence) exists for any M and C if
/// det K < 0; growth of a complex pair (flutter) depends on M and C (V. V. Bolotin, Nonconservative Problems
/// of the Theory of Elastic Stability, 1963). Unknowns with neither mass nor damping get
///   C = τ G,   G the linear stiffness,   τ = 1 ms                                          (2)
/// One step of the trapezoidal rule over 2/σ is the Cayley transform of (1), with one factorisation:
///   (K + σC + σ²M) d = 2 (σM v − K y),   y ← y + d,   v ← σ d − v,   v = ẏ                 (3)
///   A: (y, v) → (y, v),   eigenvalues μ = (σ + s)/(σ − s)                                  (4)
/// A has an eigenvalue outside the unit circle if and only if some Re s > 0, most clearly for σ ≈ |s| (K.
/// Meerbergen and D. Roose, IMA J. Numer. Anal. 16, 1996). 24 steps of the Arnoldi iteration find the
/// outermost eigenvalue for each shift σ. The first shift is a tenth of (6c) in linear_motion.hpp, each other
/// one a hundredth of the one before it. The last is 1e-3/s, or the first for which no Ritz value is slower
/// than σ/10: slow motions are at the edge of the spectrum of A, next to 1, so that few steps find them. A
/// Ritz value θ outside the circle counts if its residual ρ and the cosine χ of the angle between its left
/// and right eigenvectors satisfy
///   ρ/χ ≤ (|θ| − 1)/10                                                                    (5)
/// (Y. Saad, Numerical Methods for Large Eigenvalue Problems, 2011). If (5) fails after 48 steps, A is far
/// from normal, and the growth of its powers decides (L. N. Trefethen and M. Embree, Spectra and
/// Pseudospectra, 2005). At σ = |s|, where |μ| is largest,
///   |μ| = ((1 + c)/(1 − c))^½,   c = Re s/|s|                                              (6)
/// The verdict is `marginal` if growth cannot be distinguished from none: if |μ| ≤ kMarginalGrowth, which is
/// less than 6 % per period and depends on a hundredth of the damping; if an oscillation grows in a scene
/// without damping, because a little damping may or may not stop it (Bolotin); if powers do not settle; or by
/// (7) in cayley.hpp. It is `unknown` if K + σC + σ²M could not be factorised. It depends neither on chance
/// nor on a clock. `factors` must be those of this pattern; they count the cost. The matrices in `motion` are
/// overwritten. Only the function with an assembler finds the extent of a growing motion.
Growth find_growth(Assembler& assembler, const RestPlace& place, Factors& factors, LinearMotion motion = {});
Growth find_growth(const SparsePattern& pattern, const LinearMotion& motion, Factors& factors);

}  // namespace netloft
