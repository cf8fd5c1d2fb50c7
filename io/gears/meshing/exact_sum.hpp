// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace netloft::gears {

/// A number as the exact sum of at most N doubles, which are ordered by magnitude and do not overlap
/// (Shewchuk, Discrete Comput. Geom. 18 (1997) 305). Sums, differences and products of such numbers are exact
/// as long as no double over- or underflows; zeros are left out, so that operations on short numbers stay
/// fast.
template <std::size_t N>
class ExactSum {
 public:
  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return parts_[i]; }

  int sign() const {
    const double largest = size_ == 0 ? 0 : parts_[size_ - 1];
    return (largest > 0) - (largest < 0);
  }

  /// Adds a double (Shewchuk's figure 6, with the two-sum of Knuth).
  void add(double x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = x + parts_[i], there = sum - x, error = (x - (sum - there)) + (parts_[i] - there);
      if (error != 0) parts_[kept++] = error;
      x = sum;
    }
    if (x != 0) parts_[kept++] = x;
    size_ = kept;
  }

 private:
  std::array<double, N> parts_;  // only the first size_ have a value
  std::size_t size_ = 0;
};

inline ExactSum<2> exact_difference(double a, double b) {
  ExactSum<2> difference;
  difference.add(a);
  difference.add(-b);
  return difference;
}

template <std::size_t N, std::size_t M>
ExactSum<N + M> operator+(const ExactSum<N>& a, const ExactSum<M>& b) {
  ExactSum<N + M> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.add(a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) sum.add(b[i]);
  return sum;
}

template <std::size_t N, std::size_t M>
ExactSum<N + M> operator-(const ExactSum<N>& a, const ExactSum<M>& b) {
  ExactSum<N + M> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.add(a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) sum.add(-b[i]);
  return sum;
}

template <std::size_t N, std::size_t M>
ExactSum<2 * N * M> operator*(const ExactSum<N>& a, const ExactSum<M>& b) {
  ExactSum<2 * N * M> product;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) {
      const double rounded = a[i] * b[k];
      product.add(std::fma(a[i], b[k], -rounded));
      product.add(rounded);
    }
  return product;
}

}  // namespace netloft::gears
