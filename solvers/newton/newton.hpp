// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::newton {

/// Newton's method for r(u) = 0, in two behaviours.
///
/// "classic", the Newton-Raphson iteration of the trawl-gear paper, eq. 5 and 6, undamped, as published:
///   F'(q_i) (q_{i+1} − q_i) = −F(q_i)                                                   (1)
///
/// "globalised", for problems whose forces have an energy E, all or in part. g is its gradient and r = g + d,
/// where d are the forces without an energy (drag). M is the linear stiffness, which bounds the convex part
/// K₊ of K.
///   (K + θ (K₊ − K) + μ M) s = −r, θ of 0, 2⁻¹², … ½, 1 so that it is positive definite   (2)
///   m(t) = E(u + t s) + ½ t [d(u) + d(u + t s)]·s, m'(t) ≈ r(u + t s)·s                   (3)
///   m(t) ≤ m(0) + c t r·s and |m'(t)| ≤ η |r·s|, or t = 1                                (4)
///   m(1) ≤ m(0) − c_up r·s is enough after a step that was not such a one                 (5)
///   |s'| ≤ |s| / 2, (K + μ M) s' = −r(u + s) with the matrix of u                         (6)
///   u + t v, K v = λ M v with the least λ < 0, m'(t) ≈ 0                                   (7)
///   |m'(t)| ≤ |m'(0)| / 10 or t = 1 and m'(1) ≤ 0, m(t) not above m(0) but for rounding    (8)
///   u + t s + ½ t² a, a = −(K + θ (K₊ − K) + μ M)⁻¹ r″(s, s)                              (9)
/// The second term of (3) is the work of d on the way, by the trapezoidal rule; the slope is that of the work
/// itself, which differs by ¼ t² s·d″, zero at t = 0. Were d frozen as a dead load,
/// it would turn back what it turns with: a long cod-end swings about the ring that holds it with a catch
/// that pulls a million times as hard as anything keeps it from swinging (195 unknowns, `--draw 57`: 862
/// factorisations instead of 31, and no end in 1000 instead of 53).
/// (5) lets an iterate cross the kinks between slack and taut, one step at a time (watched as by Chamberlain
/// et al. 1982, Math. Programming Study 16). μ falls after a whole step and rises after a short one. With θ =
/// 1 and μ = 1 the step cannot raise a convex energy (Levenberg 1944, in the metric of the linear stiffness);
/// with neither it is Newton's. All of the convex part is often more than it takes: of a pressed twine it
/// leaves out what its neighbours hold. An unsymmetric K is not asked whether it is positive definite: μ
/// rises until s leads downhill. Near the end m has no digits left for (4); then a step counts that does not
/// raise ‖r‖, or that (6) says halves what is left (the natural monotonicity test of Deuflhard, Newton
/// Methods for Nonlinear Problems, 2004): in stiff parts rounding alone may keep ‖r‖ where it is. With drag,
/// a step that quarters ‖r‖ counts as well: d has then moved little. Where neither does, (8) goes by the
/// slope, which still has digits, as long as −r·s halves now and then: what is slack at u is taut on the way,
/// one member after the other.
/// (7) follows (2) where K is indefinite and K + σ M is not, which then is the
/// matrix of (2), for a σ of 1e-7, 1e-6, … 1e-4: a saddle that symmetry hides, such as a plane net's whose
/// edge would fold (a direction of negative curvature: J. J. Moré and D. C. Sorensen, Math. Programming 16,
/// 1979). Also where E has no digits left and no step leads on.
/// (9) is tried where (4) ends short, if all forces have an energy, and taken if it gains 1.5 times as much:
/// what is stiff and turns moves in a bent valley, which straight steps leave the sooner the steeper it is
/// ("geodesic acceleration": M. K. Transtrum and J. P. Sethna, arXiv:1201.5885, 2012). A valley a million
/// times as steep across as along takes 3 steps instead of 379 (`bent_step_test.cpp`).
struct Newton {
  struct Parameters {
    std::int64_t method = 0;
    double damping = 0, decrease = 0, flatness = 0, uphill = 0, shortest_step = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::newton
