// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::newton {

/// Newton's method for r(u) = 0, in two behaviours.
///
/// "classic", the Newton-Raphson iteration of "Modeling and simulation of bottom trawl gears", eq. 5 and 6,
/// undamped, as published:
///   F'(q_i) (q_{i+1} − q_i) = −F(q_i)                                                   (1)
///
/// "globalised", for problems whose forces have an energy E, all or in part. g is its gradient and r = g + d,
/// where d are the forces without an energy (drag). K is the tangent, the derivative of r; K₊ a positive
/// semi-definite part of it, as elements give it; M the linear stiffness, which is constant and bounds that
/// part, s·K₊s ≤ s·Ms.
///   (K + θ (K₊ − K) + μ M) s = −r, θ of 0, … 1 so that it is positive definite            (2)
///   m(t) = E(u + t s) + ½ t [d(u) + d(u + t s)]·s, m'(t) ≈ r(u + t s)·s                   (3)
///   t by (L) of line_search.hpp: m does not rise, and is nearly flat                      (4)
///   before (4): t = 1 if s moves no node by more than the length of an element and m(1) ≤ m(0) + b, with
///   b = −c r·s, c the option `uphill`, where m is as low as it has ever been, else b = 0   (5)
///   u ± t v, K v = λ M v with the least λ < 0, t by (D) of descent_search.hpp             (6)
///   t by (S) of line_search.hpp: m is nearly flat and not above m(0) but for rounding     (7)
///   u + t s + ½ t² a, a = −(K + θ (K₊ − K) + μ M)⁻¹ r″(s, s)                              (8)
/// The second term of (3) is the work of d along the path, by the trapezoidal rule; the slope is that of the
/// work itself, which differs by ¼ t² s·d″, zero at t = 0. A dead load d(u) in its place would not turn with
/// the gear.
///
/// Direction. The first step is Newton's own, θ = μ = 0, if it leads downhill and moves no node by more than
/// the length of an element: the start may be an equilibrium but for a little; μ is then 0. Else μ begins at
/// `damping`. It is divided by `factor` after a step by m with t > ½ and after one by ‖r‖. It is multiplied
/// by 1/(2 t) after a shorter step by m, and by `factor` where no step is found; from 0 it then rises to
/// `least_damping`. After a step by (7) or by (6) alone it is what the matrix of that step had: μ, σ where K
/// was nearly definite, or 0 after the undamped step at round-off. Below `least_damping` there
/// is none; an unsymmetric K is damped down to the rounding of a double, and from its root on if damping is
/// wanted again, since soft parts of a gear need less than stiff ones. With θ = 1 and μ = 1 the step cannot
/// raise a convex energy (Levenberg 1944, in the metric of the linear stiffness). θ is halved from step to
/// step and doubled until the matrix is positive definite. An unsymmetric K is not asked whether it is
/// positive definite: μ rises until s leads downhill.
///
/// Globalisation. (4) is the strong Wolfe condition (Nocedal and Wright 2006, ch. 3) without its sufficient
/// decrease. (5) lets an iterate cross the kinks between slack and taut by a relaxed test as in the watchdog
/// technique (Chamberlain et al. 1982, Math. Programming Search 16), but without its return to the point
/// before: m is as low as the sum of what all steps by (4) to (6) and (8) have lowered it by, and after a
/// step that raised m no other may raise it until that sum is what it was before. Where every other step
/// might go uphill, from wherever it stood, netting on a bed with friction made a thousand steps about its
/// equilibrium. A step from afar promises so much that (5) would allow any: of a drawn ring of bent rope it
/// let the energy rise thirtyfold. (8) is tried where (4) ends short of t = 1 or finds no t, all forces have
/// an energy and K is symmetric ("geodesic acceleration": M. K. Transtrum and J. P. Sethna, arXiv:1201.5885,
/// 2012).
///
/// At round-off, where the step promises less than the energy can resolve, the whole step is taken if it does
/// not raise ‖r‖; else, where μ = 0, a step by (7), the approximate Wolfe conditions (W. W. Hager and H.
/// Zhang, SIAM J. Optim. 16, 2005). Where neither and no (6) has moved, K is factorised once without damping:
/// if it is positive definite, or unsymmetric, its step is tried in the same two ways; if it is nearly
/// definite, (6), and (7) where nothing curves downwards.
///
/// Negative curvature. Where all forces have an energy, μ is small, K is indefinite and K + σ M with a σ
/// of `least_damping` to kMatters is not, K is nearly definite: K + σ M is then the matrix of (2). The step
/// by it is tried like any other; then, whether it was accepted or not, (6) goes on from where the iterate
/// stands and leaves the saddle (J. J. Moré and D. C. Sorensen, Math. Programming 16, 1979), with no node
/// going farther than 1/`margin` elements. Where no such σ is found, or μ has reached kMatters, it is not
/// tried again until K + μ M has been positive definite.
///
/// Failure. Without a step and with μ at `most_damping` the step is too short; (7) gives up, too, where −r·s
/// has not halved in `refinements` tries. The method ends as well where no matrix can be factorised, or
/// elements have no force at the point.
struct Newton {
  struct Parameters {
    std::int64_t method = 0;
    double damping = 0, least_damping = 0, most_damping = 0, factor = 0;
    double flatness = 0, uphill = 0, margin = 0;
    std::int64_t refinements = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::newton
