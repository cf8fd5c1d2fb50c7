// SPDX-License-Identifier: BSD-3-Clause
//
// Rotations given by a vector ψ, their spin ω and angular acceleration α, for doubles and dual numbers.
//   R r = r + a ψ×r + b ψ×(ψ×r),   φ = ‖ψ‖,  a = sin φ/φ,  b = (1 − cos φ)/φ²       rotation by ψ      (1)
//   ω = T ψ̇ = ψ̇ + b ψ×ψ̇ + c ψ×(ψ×ψ̇),   c = (φ − sin φ)/φ³                         spin, dR/dt = ω× R (2)
//   α = dω/dt = T ψ̈ + ḃ ψ×ψ̇ + ċ ψ×(ψ×ψ̇) + c ψ̇×(ψ×ψ̇)                                                  (3)
//   Tᵀm = m − b ψ×m + c ψ×(ψ×m)                    generalised force of a moment m: its power is m·ω (4)
// a, b and c are smooth functions of s = φ². ψ and ψ(1 − 2π/φ) are the same rotation; T is singular if φ is a
// full turn. Source: J. Argyris, An excursion into large rotations, Computer Methods in Applied Mechanics and
// Engineering 32 (1982), 85-155.
#pragma once
#include <netloft/dual.hpp>
#include <netloft/vec3.hpp>

#include <array>
#include <cmath>

namespace netloft {

namespace detail {

/// The factors a, b, c of (1) and (2), and the derivatives of b and c with respect to s.
template <class T>
struct RotationFactors {
  T a, b, c, db, dc;
};

/// Computes the sum over k of (−s)^k/(2k + n)!, which is a, b, c for n = 1, 2, 3, and the derivative of the
/// sum. Valid for s < 1.
template <class T>
void sum_rotation_series(const T& s, int n, T& sum, T& slope) {
  constexpr int kTerms = 10;  // enough for double precision: 1/21! is negligible
  sum = slope = T(0);
  double factorial = 1;
  for (int i = 2; i <= n; ++i) factorial *= i;
  std::array<double, kTerms> terms;
  for (int k = 0; k < kTerms; ++k) {
    terms[static_cast<std::size_t>(k)] = (k % 2 ? -1 : 1) / factorial;
    factorial *= (2 * k + n + 1) * (2 * k + n + 2);
  }
  for (int k = kTerms - 1; k >= 0; --k) {
    slope = slope * s + sum;
    sum = sum * s + T(terms[static_cast<std::size_t>(k)]);
  }
}

template <class T>
RotationFactors<T> rotation_factors(const T& s) {
  using std::cos, std::sin, std::sqrt;
  RotationFactors<T> f;
  if (s < T(1)) {
    T unused;
    sum_rotation_series(s, 1, f.a, unused);
    sum_rotation_series(s, 2, f.b, f.db);
    sum_rotation_series(s, 3, f.c, f.dc);
    return f;
  }
  const T phi = sqrt(s), cosine = cos(phi);
  f.a = sin(phi) / phi;
  f.b = (T(1) - cosine) / s;
  f.c = (T(1) - f.a) / s;
  const T da = (cosine - f.a) / (2.0 * s);
  f.db = (0.5 * f.a - f.b) / s;
  f.dc = (-da - f.c) / s;
  return f;
}

}  // namespace detail

/// Returns R r, the vector r rotated by ψ (1).
template <class T>
Vec3<T> rotated(const Vec3<T>& psi, const Vec3<T>& r) {
  const auto f = detail::rotation_factors<T>(dot(psi, psi));
  const Vec3<T> once = cross(psi, r);
  return r + f.a * once + f.b * cross(psi, once);
}

/// Returns the axes of a body that is rotated by ψ: the columns of R.
template <class T>
std::array<Vec3<T>, 3> turned_axes(const Vec3<T>& psi) {
  return {rotated(psi, Vec3<T>{T(1), T(0), T(0)}), rotated(psi, Vec3<T>{T(0), T(1), T(0)}),
          rotated(psi, Vec3<T>{T(0), T(0), T(1)})};
}

/// Returns the spin ω of a rotation vector ψ at its rate ψ̇, by (2) above.
template <class T>
Vec3<T> spin_of(const Vec3<T>& psi, const Vec3<T>& rate) {
  const auto f = detail::rotation_factors<T>(dot(psi, psi));
  const Vec3<T> once = cross(psi, rate);
  return rate + f.b * once + f.c * cross(psi, once);
}

/// Returns the angular acceleration α of a rotation vector ψ at its rates ψ̇ and ψ̈, by (3) above.
template <class T>
Vec3<T> spin_rate_of(const Vec3<T>& psi, const Vec3<T>& rate, const Vec3<T>& second) {
  const auto f = detail::rotation_factors<T>(dot(psi, psi));
  const T ds = 2.0 * dot(psi, rate);
  const Vec3<T> once = cross(psi, rate), again = cross(psi, second);
  return second + f.b * again + f.c * cross(psi, again) + (f.db * ds) * once +
         (f.dc * ds) * cross(psi, once) + f.c * cross(rate, once);
}

/// Returns Tᵀm by (4) above: the generalised force that does the work of the moment m on the rotation vector
/// ψ.
template <class T>
Vec3<T> moment_on_vector(const Vec3<T>& psi, const Vec3<T>& moment) {
  const auto f = detail::rotation_factors<T>(dot(psi, psi));
  const Vec3<T> once = cross(psi, moment);
  return moment - f.b * once + f.c * cross(psi, once);
}

/// Returns T⁻¹ω = ω − ψ×ω/2 + d ψ×(ψ×ω), d = (1 − a/2b)/φ²: the rate of the rotation vector ψ at the spin ω.
/// With −ψ instead of ψ, the function inverts (4): it returns m for a given Tᵀm. The angle φ = ‖ψ‖ must not
/// be a full turn.
inline Vec3<double> rate_of_spin(const Vec3<double>& psi, const Vec3<double>& omega) {
  const double s = dot(psi, psi);
  const auto f = detail::rotation_factors<double>(s);
  // For small s, 2b − a suffers from cancellation. d is therefore the sum of the first two terms of its
  // series.
  const double d = s < 1e-4 ? 1.0 / 12 + s / 720 : (2 * f.b - f.a) / (2 * f.b * s);
  const Vec3<double> once = cross(psi, omega);
  return omega - 0.5 * once + d * cross(psi, once);
}

/// Returns the rotation vector of at most half a turn that rotates the axes of the world into `axes`, which
/// must be orthonormal and right-handed.
inline Vec3<double> rotation_vector(const std::array<Vec3<double>, 3>& axes) {
  const auto R = [&](int row, int column) { return axes[static_cast<std::size_t>(column)][row]; };
  const double trace = R(0, 0) + R(1, 1) + R(2, 2);
  // The quaternion is computed from its largest component (S. W. Shepperd, J. Guidance and Control 1, 1978).
  int largest = 3;
  for (int i = 0; i < 3; ++i)
    if (R(i, i) > (largest == 3 ? trace : R(largest, largest))) largest = i;
  Vec3<double> q;
  double w;
  if (largest == 3) {
    w = 1 + trace;
    q = {R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
  } else {
    const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
    q[i] = 1 + R(i, i) - R(j, j) - R(k, k);
    q[j] = R(i, j) + R(j, i);
    q[k] = R(i, k) + R(k, i);
    w = R(k, j) - R(j, k);
  }
  const double sine = norm(q);
  if (sine == 0) return {0, 0, 0};
  if (w < 0) {
    w = -w;
    q = -q;
  }
  const double phi = 2 * std::atan2(sine, w);
  return (phi / sine) * q;
}

/// Returns the vector of at most half a turn that describes the same rotation as psi.
inline Vec3<double> shortened(const Vec3<double>& psi) {
  constexpr double kTurn = 6.283185307179586476925286766559;
  const double phi = norm(psi);
  return phi > 0 ? ((phi - kTurn * std::round(phi / kTurn)) / phi) * psi : psi;
}

}  // namespace netloft
