// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>

namespace netloft {

/// A number with its gradient and, if Order is 2, its Hessian with respect to N variables (automatic
/// differentiation, forward mode). Dual numbers are slow, but they compute the force and the tangent of an
/// element from its energy alone. Tests compare faster code with dual numbers.
template <int N, int Order = 2>
struct Dual {
  double value = 0;
  std::array<double, N> gradient{};
  std::array<double, Order == 2 ? N*(N + 1) / 2 : 0> hessian{};  // lower triangle, entry r(r+1)/2 + c

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: a plain number is a constant

  static Dual variable(double v, int index) {
    Dual d(v);
    d.gradient[static_cast<std::size_t>(index)] = 1;
    return d;
  }

  /// Applies the chain rule: returns f(this), given f, f' and f'' at the value.
  Dual chain(double f, double f1, double f2) const {
    Dual d(f);
    [[maybe_unused]] std::size_t k = 0;
    for (std::size_t r = 0; r < N; ++r) {
      d.gradient[r] = f1 * gradient[r];
      if constexpr (Order == 2)
        for (std::size_t c = 0; c <= r; ++c, ++k)
          d.hessian[k] = f1 * hessian[k] + f2 * gradient[r] * gradient[c];
    }
    return d;
  }

  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend Dual operator-(const Dual& a) { return a.chain(-a.value, -1, 0); }
  friend Dual operator+(const Dual& a, const Dual& b) { return combine(a, 1, b, 1, a.value + b.value); }
  friend Dual operator-(const Dual& a, const Dual& b) { return combine(a, 1, b, -1, a.value - b.value); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual d = combine(a, b.value, b, a.value, a.value * b.value);
    std::size_t k = 0;
    for (std::size_t r = 0; r < N && Order == 2; ++r)
      for (std::size_t c = 0; c <= r; ++c, ++k)
        d.hessian[k] += a.gradient[r] * b.gradient[c] + b.gradient[r] * a.gradient[c];
    return d;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double i = 1 / b.value;
    return a * b.chain(i, -i * i, 2 * i * i * i);
  }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  /// The square root has no derivative at zero. Setting it to zero makes the derivative of ‖w‖ w correct for
  /// a vector w = 0.
  friend Dual sqrt(const Dual& a) {
    const double s = std::sqrt(a.value);
    return s == 0 ? Dual(0) : a.chain(s, 0.5 / s, -0.25 / (s * a.value));
  }
  friend Dual log(const Dual& a) { return a.chain(std::log(a.value), 1 / a.value, -1 / (a.value * a.value)); }
  friend Dual exp(const Dual& a) {
    const double e = std::exp(a.value);
    return a.chain(e, e, e);
  }
  friend Dual sin(const Dual& a) { return a.chain(std::sin(a.value), std::cos(a.value), -std::sin(a.value)); }
  friend Dual cos(const Dual& a) {
    return a.chain(std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
  }
  friend Dual acos(const Dual& a) {
    const double q = 1 - a.value * a.value, s = std::sqrt(q);
    return a.chain(std::acos(a.value), -1 / s, -a.value / (q * s));
  }
  friend Dual atan(const Dual& a) {
    const double q = 1 / (1 + a.value * a.value);
    return a.chain(std::atan(a.value), q, -2 * a.value * q * q);
  }
  friend Dual asin(const Dual& a) {
    const double q = 1 - a.value * a.value, s = std::sqrt(q);
    return a.chain(std::asin(a.value), 1 / s, a.value / (q * s));
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double square = x.value * x.value + y.value * y.value;
    // (ahead, turn) is the vector (x, y), up to a factor, in axes of which the first has the direction of the
    // values (x.value, y.value). In these axes, the angle of the vector is zero and has the derivatives of
    // the result.
    const Dual turn = (x.value * y - y.value * x) / square;
    const Dual ahead = (x.value * x + y.value * y) / square;
    return std::atan2(y.value, x.value) + atan(turn / ahead);
  }
  friend Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }
  friend Dual pow(const Dual& a, double p) {
    const double f = std::pow(a.value, p);
    return a.chain(f, p * std::pow(a.value, p - 1), p * (p - 1) * std::pow(a.value, p - 2));
  }

 private:
  static Dual combine(const Dual& a, double fa, const Dual& b, double fb, double value) {
    Dual d(value);
    for (std::size_t r = 0; r < N; ++r) d.gradient[r] = fa * a.gradient[r] + fb * b.gradient[r];
    for (std::size_t k = 0; k < d.hessian.size(); ++k) d.hessian[k] = fa * a.hessian[k] + fb * b.hessian[k];
    return d;
  }
};

}  // namespace netloft
