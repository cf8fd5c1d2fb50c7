// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::catches {

/// Pressure of the flow that the catch stops. It acts from inside on all netting behind a plane across the
/// flow, the front:
///   p = p₀ + C_d ½ ρ V²                                                                        (1)
///   n = o (x₂−x₁)×(x₃−x₁)                      outward normal, length twice the area             (2)
///   e = (cos ψ, sin ψ, 0),  s_i = e·x_i − ξ    distance of corner i behind the plane             (3)
///   I(s) = mean of max(s, 0) over the triangle,  w_i = ∂I/∂s_i                                    (4)
///   r_i = −(w_i p/2) n                         residual on each corner                           (5)
///   v = I n·e/2                                contribution of the triangle to the volume        (6)
///   r_ξ = k (σ V₀ − Σ v) = 0,  k = p/∛V₀                 r_ξ grows with ξ                       (7)
/// If only corner a is behind the plane, with t_b = s_a/(s_a − s_b) and t_c alike,
///   I = s_a t_b t_c/3,  w_a = t_b t_c (1 − (t_b+t_c)/3),  w_b = t_b² t_c/3,  w_c = t_b t_c²/3     (8)
/// If only one corner is ahead, I(s) = s̄ + I(−s) and w_i(s) = ⅓ − w_i(−s), with s̄ the mean of the s_i. If
/// all three are behind, I = s̄ and w_i = ⅓. p₀ [Pa] is a given pressure, V [m/s] the speed of the water, C_d
/// the drag coefficient of the catch, ψ the direction of the flow, ξ [m] the position of the plane along the
/// flow. All triangles of a part share ξ, which is either given or an unknown with the equation (7). In (7),
/// V₀ [m³] is the volume of the catch (half of it if half a gear is modelled), and σ [1] the fraction of V₀
/// at a given time, from a table (linear between its times), or 1 without a table. By the theorem of Gauss, Σ
/// v is the volume between the plane and the netting, if the netting is closed behind the plane. o is 1 if
/// the corners are counter-clockwise seen from outside, and −1 if they are clockwise. Source: the catch of
/// FEMNET (D. Priour), where ξ is found by bisection and has no tangent.
struct Front {
  static constexpr auto stencil = NETLOFT_TRIANGLE;
  static constexpr int globals = 1;  // shared unknown: ξ

  struct Parameters {
    double pressure = 0, speed = 0, drag_coefficient = 0, volume = 0, front = 0, direction = 0;
    netloft_table growth{};  // columns: time t [s], fraction σ
  };
  struct Data {
    double outward = 1;  // sign o of (2)
  };
  struct Whole {
    double triangles = 0;
  };
  /// The mean I of (4) for one triangle, and its derivatives w with respect to the distances s of the
  /// corners.
  template <class T>
  struct Behind {
    T I{};
    std::array<T, 3> w{};
  };

  static void check(const Parameters& p, const Data&);
  static void gather(const Parameters&, const Data&, Whole& whole) { ++whole.triangles; }
  static double first_front(const Parameters& p, const Whole&) { return p.front; }
  template <class T>
  static Behind<T> behind(const std::array<T, 3>& s);
  static double full(const Parameters& p, const Water& w);                      // pressure p [Pa]
  static double volume(const Parameters& p, const Data& d, const State<4>& s);  // volume v [m³]
  static double on(const Parameters& p, const Data& d, const State<4>& s);      // p Σ w [Pa]

  struct Push {
    static Status evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<4>& s,
                           Local<4>& out);
  };
};

/// Computes I and w by (8) of Front. Corner `a` is alone on its side of the plane.
template <class T>
Front::Behind<T> corner_behind(const std::array<T, 3>& s, std::size_t a) {
  const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
  const T tb = s[a] / (s[a] - s[b]), tc = s[a] / (s[a] - s[c]);
  Front::Behind<T> out;
  out.I = (1.0 / 3) * (s[a] * tb * tc);
  out.w[a] = tb * tc * (1.0 - (1.0 / 3) * (tb + tc));
  out.w[b] = (1.0 / 3) * (tb * tb * tc);
  out.w[c] = (1.0 / 3) * (tb * tc * tc);
  return out;
}

template <class T>
Front::Behind<T> Front::behind(const std::array<T, 3>& s) {
  const int count = (s[0] > T(0)) + (s[1] > T(0)) + (s[2] > T(0));
  if (count == 0) return {};
  Behind<T> all;
  all.I = (1.0 / 3) * (s[0] + s[1] + s[2]);
  all.w.fill(T(1.0 / 3));
  if (count == 3) return all;
  std::size_t lone = 0;
  while ((s[lone] > T(0)) != (count == 1)) ++lone;
  if (count == 1) return corner_behind(s, lone);
  const Behind<T> ahead = corner_behind(std::array<T, 3>{-s[0], -s[1], -s[2]}, lone);
  all.I += ahead.I;
  for (std::size_t i = 0; i < 3; ++i) all.w[i] -= ahead.w[i];
  return all;
}

}  // namespace netloft::catches
