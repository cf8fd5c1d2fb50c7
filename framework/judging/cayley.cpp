// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/cayley.hpp"

#include <netloft/vectors.hpp>

#include <cmath>
#include <limits>

namespace netloft {

namespace {

using Vector = Eigen::VectorXd;

// Rounding error of K in (7) of cayley.hpp, relative to its entries.
constexpr double kRoundingOfK = 10 * std::numeric_limits<double>::epsilon();

/// Copies the non-zero values of a matrix.
Eigen::SparseMatrix<double> make_sparse(const SparsePattern& p, std::span<const double> values) {
  Eigen::SparseMatrix<double> A(p.size, p.size);
  A.reserve(static_cast<Eigen::Index>(p.entries()));
  for (std::int32_t c = 0; c < p.size; ++c) {
    A.startVec(c);
    const auto begin = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]),
               end = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]);
    for (std::size_t k = begin; k < end; ++k)
      if (const double value = values[p.slot_of(k)]; value != 0) A.insertBack(p.row[k], c) = value;
  }
  A.finalize();
  if (p.symmetric) A = Eigen::SparseMatrix<double>(A.selfadjointView<Eigen::Lower>());
  return A;
}

std::span<double> span_of(Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

}  // namespace

Cayley::Cayley(const SparsePattern& p, const LinearMotion& m, Factorisation& factor, Statistics& cost)
    : motion_(m),
      K_(make_sparse(p, m.K)),
      C_(make_sparse(p, m.C)),
      M_(make_sparse(p, m.M)),
      convex_(make_sparse(p, m.convex)),
      K_error_(m.K_error.empty() ? Eigen::SparseMatrix<double>(p.size, p.size) : make_sparse(p, m.K_error)),
      factor_(factor),
      cost_(cost),
      sum_(m.K.size()),
      rhs_(p.size),
      d_(p.size) {
  const Vector masses = M_.cwiseAbs() * Vector::Ones(unknowns());
  dimension_ = unknowns() + (masses.array() > 0).count();
}

bool Cayley::set(double sigma) {
  sigma_ = sigma;
  norm_ = convex_ + sigma * sigma * M_;
  for (std::size_t i = 0; i < sum_.size(); ++i)
    sum_[i] = motion_.K[i] + sigma * (motion_.C[i] + sigma * motion_.M[i]);
  ++cost_.factorisations;
  return factor_.factorise(sum_).status == FactorStatus::ok;
}

Vector Cayley::operator*(const Vector& z) {
  const auto y = z.head(unknowns()), v = z.tail(unknowns());
  rhs_.noalias() = sigma_ * (M_ * v);
  rhs_.noalias() -= K_ * y;
  rhs_ *= 2;
  factor_.solve(span_of(rhs_), span_of(d_));
  ++cost_.solves;
  Vector to(z.size());
  to.head(unknowns()) = y + d_;
  to.tail(unknowns()) = sigma_ * d_ - v;
  return to;
}

Vector Cayley::weighed(const Vector& z) const {
  const auto y = z.head(unknowns()), v = z.tail(unknowns());
  Vector to(z.size());
  to.head(unknowns()).noalias() = norm_ * y;
  to.tail(unknowns()).noalias() = M_ * v;
  return to;
}

Vector Cayley::start() const {
  Vector z(2 * unknowns());
  scatter(span_of(z));
  return z;
}

bool Cayley::is_in_doubt(std::complex<double> s, const Eigen::VectorXcd& y) const {
  const Eigen::VectorXcd driven = s * (C_ * y) + s * s * (M_ * y);
  if (driven.norm() <= kRoundingOfK * (K_.cwiseAbs() * y.cwiseAbs()).norm()) return true;
  const double wanted = y.dot(driven).real(), change = y.dot(K_error_ * y).real();
  return s.imag() == 0 && wanted > 0 && change >= wanted;
}

}  // namespace netloft
