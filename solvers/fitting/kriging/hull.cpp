// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/kriging/hull.hpp"

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>

namespace netloft {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

// Round-off of a distance and of its derivative, if coordinates are about one.
constexpr double kNoDistance = 1e-9, kNoSlope = 1e-12;

/// Minimises ‖A λ − b‖ over λ ≥ 0 by the active-set method of Lawson and Hanson, with its functions in the
/// order of the algorithm.
class LeastSquaresOfWeights {
 public:
  LeastSquaresOfWeights(const Matrix& a, const Vector& b) : a_(a), b_(b), weights_(Vector::Zero(a.cols())) {}

  double distance() {
    for (Index step = 0; step < 3 * (a_.cols() + a_.rows()); ++step) {
      const Vector residual = b_ - a_ * weights_;
      const Index best = steepest(residual);
      if (residual.norm() < kNoDistance || best < 0) break;
      free_.push_back(best);
      while (!move_to_least()) drop_zeros();
    }
    return (b_ - a_ * weights_).norm();
  }

 private:
  /// Returns the index of the weight whose increase reduces the distance most, or -1 if none reduces it.
  Index steepest(const Vector& residual) const {
    const Vector slope = a_.transpose() * residual;
    Index best = -1;
    for (Index i = 0; i < slope.size(); ++i)
      if (std::find(free_.begin(), free_.end(), i) == free_.end() && slope[i] > kNoSlope &&
          (best < 0 || slope[i] > slope[best]))
        best = i;
    return best;
  }

  /// Moves towards the least-squares solution of the free weights, until one of these weights becomes zero.
  /// Returns whether it has reached that solution.
  bool move_to_least() {
    Matrix columns(a_.rows(), static_cast<Index>(free_.size()));
    for (std::size_t k = 0; k < free_.size(); ++k) columns.col(static_cast<Index>(k)) = a_.col(free_[k]);
    const Vector target = columns.colPivHouseholderQr().solve(b_);
    double reach = 1;
    for (std::size_t k = 0; k < free_.size(); ++k)
      if (const double to = target[static_cast<Index>(k)], from = weights_[free_[k]]; to <= 0)
        reach = std::min(reach, from / (from - to));
    if (!(reach >= 0)) reach = 0;
    for (std::size_t k = 0; k < free_.size(); ++k)
      weights_[free_[k]] += reach * (target[static_cast<Index>(k)] - weights_[free_[k]]);
    return reach == 1;
  }

  void drop_zeros() {
    std::erase_if(free_, [&](Index i) {
      if (weights_[i] > kNoSlope) return false;
      weights_[i] = 0;
      return true;
    });
  }

  const Matrix& a_;
  const Vector& b_;
  Vector weights_;
  std::vector<Index> free_;
};

}  // namespace

bool lies_in_hull(const std::vector<std::vector<double>>& points, const std::vector<double>& point) {
  const auto n = static_cast<Index>(points.size()), d = static_cast<Index>(point.size());
  if (n == 0) return false;
  Matrix a(d + 1, n);
  Vector b(d + 1);
  for (Index j = 0; j <= d; ++j) {
    b[j] = j < d ? point[static_cast<std::size_t>(j)] : 1;
    for (Index i = 0; i < n; ++i)
      a(j, i) = j < d ? points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] : 1;  // (1)
  }
  return LeastSquaresOfWeights(a, b).distance() < kNoDistance;
}

}  // namespace netloft
