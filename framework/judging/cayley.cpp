// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/cayley.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft {

namespace {

using Vector = Eigen::VectorXd;

// Rounding error of K in (7) of cayley.hpp, relative to its entries.
constexpr double kRoundingOfK = 10 * std::numeric_limits<double>::epsilon();

/// Adds A x to y, for a pattern that is not symmetric. Three columns that have the same rows, as those of a
/// node do, take one pass over these rows.
void add_whole_product(const SparsePattern& p, std::span<const double> A, const double* x, double* y) {
  const std::int32_t *start = p.column_start.data(), *row = p.row.data();
  const auto value = [&](std::int32_t k) { return A[p.slot_of(static_cast<std::size_t>(k))]; };
  for (std::int32_t c = 0, last; c < p.size; c = last) {
    const std::int32_t k1 = start[c], rows = start[c + 1] - k1;
    const bool are_three = c + 3 <= p.size && start[c + 3] - k1 == 3 * rows &&
                           std::equal(row + k1, row + k1 + rows, row + k1 + rows) &&
                           std::equal(row + k1, row + k1 + rows, row + k1 + 2 * rows);
    last = are_three ? c + 3 : c + 1;
    if (are_three)
      for (std::int32_t k = k1; k < k1 + rows; ++k)
        y[row[k]] += value(k) * x[c] + value(k + rows) * x[c + 1] + value(k + 2 * rows) * x[c + 2];
    else
      for (std::int32_t k = k1; k < k1 + rows; ++k) y[row[k]] += value(k) * x[c];
  }
}

/// Adds A x to y.
void add_product(const SparsePattern& p, std::span<const double> A, const Vector& x, Vector& y) {
  if (!p.symmetric) return add_whole_product(p, A, x.data(), y.data());
  for_entries(
      p, [&](std::int32_t r, std::int32_t c, double a) { y[r] += a * x[c]; }, A);
}

/// Computes A y.
Eigen::VectorXcd product(const SparsePattern& p, std::span<const double> A, const Eigen::VectorXcd& y) {
  Eigen::VectorXcd to = Eigen::VectorXcd::Zero(y.size());
  for_entries(
      p, [&](std::int32_t r, std::int32_t c, double a) { to[r] += a * y[c]; }, A);
  return to;
}

std::span<double> span_of(Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

}  // namespace

Cayley::Cayley(const SparsePattern& p, const LinearMotion& m, Factors& factors)
    : pattern_(p), motion_(m), factors_(factors), sum_(m.K.size()), rhs_(p.size), w_(p.size) {
  std::vector<bool> has_mass(static_cast<std::size_t>(p.size));
  const auto keep = [&](std::int32_t r, std::int32_t c, double mass) {
    if (mass == 0) return;
    masses_.push_back({r, c, mass});
    has_mass[static_cast<std::size_t>(r)] = true;
  };
  for_entries(p, keep, m.M);
  dimension_ = unknowns() + std::count(has_mass.begin(), has_mass.end(), true);
}

bool Cayley::set(double sigma) {
  sigma_ = sigma;
  for (std::size_t i = 0; i < sum_.size(); ++i)
    sum_[i] = motion_.K[i] + sigma * (motion_.C[i] + sigma * motion_.M[i]);
  return factors_.factorise(pattern_, true, sum_) == NETLOFT_FACTOR_OK;
}

Vector Cayley::operator*(const Vector& z) {
  const auto y = z.head(unknowns()), v = z.tail(unknowns());
  const Vector sigma_y = sigma_ * y, carried = sigma_ * (sigma_y + v);
  rhs_.setZero();
  add_product(pattern_, motion_.C, sigma_y, rhs_);
  for (const auto& [r, c, mass] : masses_) rhs_[r] += mass * carried[c];
  factors_.solve(span_of(rhs_), span_of(w_));
  Vector to(z.size());
  to.head(unknowns()) = 2 * w_ - y;                 // (3a)
  to.tail(unknowns()) = 2 * sigma_ * (w_ - y) - v;  // (3a)
  return to;
}

Vector Cayley::weighed(const Vector& z) const {
  const Vector y = z.head(unknowns());
  Vector along_y = Vector::Zero(unknowns()), to = Vector::Zero(z.size());
  add_product(pattern_, motion_.convex, y, along_y);
  const double square = sigma_ * sigma_;
  for (const auto& [r, c, mass] : masses_) {
    along_y[r] += square * mass * y[c];
    to[unknowns() + r] += mass * z[unknowns() + c];
  }
  to.head(unknowns()) = along_y;
  return to;
}

Vector Cayley::start() const {
  Vector z(2 * unknowns());
  scatter(span_of(z));
  return z;
}

bool Cayley::is_in_doubt(std::complex<double> s, const Eigen::VectorXcd& y) const {
  const Eigen::VectorXcd driven =
      s * product(pattern_, motion_.C, y) + s * s * product(pattern_, motion_.M, y);
  Vector rounding = Vector::Zero(unknowns());
  const auto add = [&](std::int32_t r, std::int32_t c, double stiffness) {
    rounding[r] += std::abs(stiffness) * std::abs(y[c]);
  };
  for_entries(pattern_, add, motion_.K);
  if (driven.norm() <= kRoundingOfK * rounding.norm()) return true;
  const double wanted = y.dot(driven).real();
  if (s.imag() != 0 || !(wanted > 0) || !motion_.K_error) return false;
  const std::vector<double> error = motion_.K_error();
  return !error.empty() && y.dot(product(pattern_, error, y)).real() >= wanted;
}

}  // namespace netloft
