// SPDX-License-Identifier: BSD-3-Clause
//
// Smooth curves and surfaces through the samples of a table, for doubles and dual numbers.
//
// A curve is a cubic on every interval, with the values and slopes of the samples at the ends. Its first
// derivative is therefore continuous: solvers converge badly at a kink in a force. The slope m at a sample is
// zero if the sample is an extremum; otherwise it is a weighted harmonic mean of the difference quotients δ₁,
// δ₂ on both sides, over intervals of lengths h₁, h₂:
//   m = (w₁ + w₂)/(w₁/δ₁ + w₂/δ₂),  w₁ = 2h₂ + h₁, w₂ = h₂ + 2h₁   where δ₁δ₂ > 0, else 0            (1)
// so that the curve is monotone wherever the samples are, and never above or below them (F. N. Fritsch and J.
// Butland, SIAM Journal on Scientific and Statistical Computing 5, 1984). A surface over two arguments has
// these slopes along both arguments, and its mixed derivative is zero at the samples f_ij. With Hermite's
// cubic polynomials H and the positions s, t of the arguments in their intervals, 0 to 1,
//   f = Σ_ij H_i(s) H_j(t) f_ij + …                        bicubic Hermite form, ∂²f/∂x∂y = 0 at samples (2)
// The first derivatives of a surface are continuous as well, and along a grid line the surface is the curve
// through the samples of that line.
//
// Beyond the samples, curve and surface keep the value at the edge, and therefore their slope at the edge is
// zero. An element must not extrapolate without notice: it calls `covers` and reports the result
// (OutputRole::doubt).
#pragma once
#include <netloft/plugin.h>
#include <netloft/dual.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft {

namespace detail {

inline double value_of(double x) { return x; }
template <int N, int Order>
double value_of(const Dual<N, Order>& x) {
  return x.value;
}

/// The slope (1) at a sample between two intervals of lengths h1, h2 and difference quotients d1, d2.
inline double slope_between(double h1, double d1, double h2, double d2) {
  if (!(d1 * d2 > 0)) return 0;
  const double w1 = 2 * h2 + h1, w2 = h2 + 2 * h1;
  return (w1 + w2) / (w1 / d1 + w2 / d2);
}

inline std::vector<double> sample_slopes(const std::vector<double>& x, const std::vector<double>& f) {
  const std::size_t n = x.size();
  std::vector<double> m(n, 0.0);
  const auto h = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto d = [&](std::size_t i) { return (f[i + 1] - f[i]) / h(i); };
  for (std::size_t i = 1; i + 1 < n; ++i) m[i] = slope_between(h(i - 1), d(i - 1), h(i), d(i));
  return m;
}

/// The interval that contains an argument: its index, its length, and the position s of the argument in the
/// interval, from 0 to 1. An argument beyond the samples counts as being at the nearest sample.
template <class T>
struct Interval {
  Interval(const std::vector<double>& x, const T& at) {
    const double value = value_of(at);
    const std::size_t last = x.size() < 2 ? 0 : x.size() - 2;
    while (first < last && x[first + 1] <= value) ++first;
    if (x.size() < 2 || !(value > x.front())) return;  // s and its derivatives stay zero
    length = x[first + 1] - x[first];
    s = value < x.back() ? (at - T(x[first])) / T(length) : T(1);
  }
  std::size_t first = 0;
  double length = 1;
  T s = T(0);

  // Hermite's cubic polynomials: the factors of the values at both ends, then those of the slopes.
  T f0() const { return (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s); }
  T f1() const { return s * s * (3.0 - 2.0 * s); }
  T m0() const { return length * s * (1.0 - s) * (1.0 - s); }
  T m1() const { return length * s * s * (s - 1.0); }
};

}  // namespace detail

/// A curve: one column of a table as a function of the first column.
class Curve {
 public:
  Curve() = default;
  Curve(std::vector<double> x, std::vector<double> f)
      : x_(std::move(x)), f_(std::move(f)), m_(detail::sample_slopes(x_, f_)) {}
  Curve(const netloft_table& table, std::uint32_t column) : Curve(read(table, 0), read(table, column)) {}

  bool empty() const { return x_.empty(); }
  bool covers(double x) const { return !empty() && x >= x_.front() && x <= x_.back(); }
  /// The value at x; zero if there are no samples.
  template <class T>
  T at(const T& x) const {
    if (empty()) return T(0);
    if (x_.size() == 1) return T(f_[0]);
    const detail::Interval<T> i(x_, x);
    const std::size_t a = i.first, b = a + 1;
    return i.f0() * f_[a] + i.f1() * f_[b] + i.m0() * m_[a] + i.m1() * m_[b];
  }

  static std::vector<double> read(const netloft_table& table, std::uint32_t column) {
    std::vector<double> values;
    for (std::uint32_t row = 0; row < table.rows; ++row)
      values.push_back(table.values[std::size_t{row} * table.columns + column]);
    return values;
  }

 private:
  std::vector<double> x_, f_, m_;
};

/// A surface: one column of a table as a function of the first two columns, whose values form a grid. Rows
/// ascend by the first column, and rows with the same first value by the second column.
class Surface {
 public:
  Surface() = default;
  /// Samples f[x][y]; x and y are ascending.
  Surface(std::vector<double> x, std::vector<double> y, std::vector<double> f)
      : x_(std::move(x)), y_(std::move(y)), f_(std::move(f)) {
    find_slopes();
  }
  Surface(const netloft_table& table, std::uint32_t column) {
    const auto first = Curve::read(table, 0), second = Curve::read(table, 1);
    f_ = Curve::read(table, column);
    for (const double x : first)
      if (x_.empty() || x > x_.back()) x_.push_back(x);
    if (!x_.empty())
      y_.assign(second.begin(), second.begin() + static_cast<std::ptrdiff_t>(f_.size() / x_.size()));
    find_slopes();
  }

  bool empty() const { return f_.empty(); }
  /// Arguments x, y and values f[x][y] of the samples.
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  const std::vector<double>& values() const { return f_; }
  bool covers(double x, double y) const {
    return !empty() && x >= x_.front() && x <= x_.back() && y >= y_.front() && y <= y_.back();
  }
  /// The range of the arguments; there must be samples.
  double first_of_x() const { return x_.front(); }
  double last_of_x() const { return x_.back(); }
  double first_of_y() const { return y_.front(); }
  double last_of_y() const { return y_.back(); }
  /// Whether the samples at y and -y are equal.
  bool is_even_in_y() const {
    for (std::size_t r = 0; r < x_.size(); ++r)
      for (std::size_t c = 0; c < y_.size(); ++c) {
        const std::size_t there = y_.size() - 1 - c;
        if (y_[there] != -y_[c] || f_[at_of(r, there)] != f_[at_of(r, c)]) return false;
      }
    return true;
  }
  /// The value at (x, y); zero if there are no samples.
  template <class T>
  T at(const T& x, const T& y) const {
    if (empty()) return T(0);
    const detail::Interval<T> i(x_, x), j(y_, y);
    const std::size_t a = i.first, b = std::min(a + 1, x_.size() - 1), c = j.first,
                      d = std::min(c + 1, y_.size() - 1);
    const auto row = [&](std::size_t r) {
      return j.f0() * f_[at_of(r, c)] + j.f1() * f_[at_of(r, d)] + j.m0() * fy_[at_of(r, c)] +
             j.m1() * fy_[at_of(r, d)];
    };
    const auto slope = [&](std::size_t r) { return j.f0() * fx_[at_of(r, c)] + j.f1() * fx_[at_of(r, d)]; };
    return i.f0() * row(a) + i.f1() * row(b) + i.m0() * slope(a) + i.m1() * slope(b);  // (2)
  }

 private:
  std::size_t at_of(std::size_t row, std::size_t column) const { return row * y_.size() + column; }
  void find_slopes() {
    fx_.assign(f_.size(), 0.0);
    fy_.assign(f_.size(), 0.0);
    std::vector<double> line;
    for (std::size_t r = 0; r < x_.size(); ++r) {
      line.assign(f_.begin() + static_cast<std::ptrdiff_t>(at_of(r, 0)),
                  f_.begin() + static_cast<std::ptrdiff_t>(at_of(r, 0) + y_.size()));
      const auto m = detail::sample_slopes(y_, line);
      std::copy(m.begin(), m.end(), fy_.begin() + static_cast<std::ptrdiff_t>(at_of(r, 0)));
    }
    for (std::size_t c = 0; c < y_.size(); ++c) {
      line.clear();
      for (std::size_t r = 0; r < x_.size(); ++r) line.push_back(f_[at_of(r, c)]);
      const auto m = detail::sample_slopes(x_, line);
      for (std::size_t r = 0; r < x_.size(); ++r) fx_[at_of(r, c)] = m[r];
    }
  }

  std::vector<double> x_, y_;
  std::vector<double> f_, fx_, fy_;  // [x][y]
};

}  // namespace netloft
