// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/arnoldi.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft {

namespace {

// Largest estimated error of a Ritz value, as a fraction of its distance from the unit circle: (5) in
// growth.hpp. The value is chosen: the estimate is correct to first order only and may be ten times too
// small.
constexpr double kErrorOfKnown = 0.1;
// A vector counts as orthogonal to the basis if orthogonalisation leaves at least this fraction of its
// length.
constexpr double kLeastRemainder = 0.5;

int rank(const RitzPair& pair, const Cayley& A, double beyond) {
  if (pair.beyond() <= beyond || !pair.is_known()) return 0;
  const std::complex<double> s = A.rate(pair.theta);
  return std::abs(s.imag()) > s.real() ? 1 : 2;
}

}  // namespace

bool RitzPair::is_known() const { return residual * condition <= kErrorOfKnown * beyond(); }

void Arnoldi::begin(const Eigen::VectorXd& z) {
  const Eigen::VectorXd weighed = A_.weighed(z);
  const double length = std::sqrt(z.dot(weighed));
  if (Q_.cols() == 0) {
    Q_.resize(z.size(), 1);
    BQ_.resize(z.size(), 1);
  }
  Q_.col(0) = z / length;
  BQ_.col(0) = weighed / length;
  H_ = Eigen::MatrixXd::Zero(1, 0);
  size_ = 0;
  is_exhausted_ = false;
}

void Arnoldi::extend(Eigen::Index steps) {
  if (Q_.cols() <= steps) {
    Q_.conservativeResize(Eigen::NoChange, steps + 1);
    BQ_.conservativeResize(Eigen::NoChange, steps + 1);
  }
  const Eigen::Index before = H_.cols();
  H_.conservativeResizeLike(Eigen::MatrixXd::Zero(steps + 1, steps));
  for (Eigen::Index k = before; k < steps && !is_exhausted_; ++k) step(k);
}

/// Adds the next basis vector. Two orthogonalisations are enough (B. N. Parlett, The Symmetric Eigenvalue
/// Problem, 1998, section 6.9). If the second one shortens the vector to less than half, the vector consists
/// of rounding errors, and A times the last basis vector was already in the space.
void Arnoldi::step(Eigen::Index k) {
  Eigen::VectorXd next = A_ * Eigen::VectorXd(Q_.col(k)), along;
  for (int i = 0; i < 2; ++i) {
    along.noalias() = BQ_.leftCols(k + 1).transpose() * next;
    next.noalias() -= Q_.leftCols(k + 1) * along;
    H_.col(k).head(k + 1) += along;
  }
  const Eigen::VectorXd weighed = A_.weighed(next);
  const double rest = std::sqrt(std::max(0.0, next.dot(weighed)));
  size_ = k + 1;
  is_exhausted_ = !(rest > kLeastRemainder * std::hypot(rest, along.norm())) || size_ == A_.dimension();
  H_(k + 1, k) = is_exhausted_ ? 0 : rest;
  if (!is_exhausted_) {
    Q_.col(k + 1) = next / rest;
    BQ_.col(k + 1) = weighed / rest;
  }
}

bool Arnoldi::sees_slow() const {
  const Eigen::VectorXcd theta = H_.topLeftCorner(size_, size_).eigenvalues();
  return std::any_of(theta.begin(), theta.end(), [&](const auto& one) { return A_.is_slow(one); });
}

RitzPair Arnoldi::outermost(double beyond) const {
  const Eigen::MatrixXd H = H_.topLeftCorner(size_, size_);
  if (!H.allFinite()) return {.theta = std::nan("")};
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(H);
  if (solver.info() != Eigen::Success) return {.theta = std::nan("")};
  const Eigen::MatrixXcd right = solver.eigenvectors(), left = right.inverse();
  RitzPair best{.theta = 0};
  Eigen::Index place = 0;
  for (Eigen::Index i = 0; i < size_; ++i) {
    const double rho = std::abs(H_(size_, size_ - 1) * right(size_ - 1, i));
    // The rows of the inverse of the matrix of right eigenvectors are left eigenvectors. The right
    // eigenvectors have length 1. Therefore the length of a row is 1/χ, with χ of (5) in growth.hpp.
    const RitzPair pair{solver.eigenvalues()[i], rho, left.row(i).norm()};
    if (A_.is_slow(pair.theta)) continue;
    const auto rank_of = [&](const RitzPair& one) {
      return std::pair(rank(one, A_, beyond), std::abs(one.theta));
    };
    if (rank_of(pair) > rank_of(best)) {
      best = pair;
      place = i;
    }
  }
  best.vector = Q_.leftCols(size_) * right.col(place);
  return best;
}

}  // namespace netloft
