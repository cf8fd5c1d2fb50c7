// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/imbalance.hpp>
#include <netloft/solver.hpp>

#include <algorithm>
#include <optional>

#include "solvers/methods/newton/damping.hpp"

namespace netloft::newton {

/// Finds σ for a tangent K that is nearly definite: K is indefinite, but K + σ M is positive definite with a
/// σ from `least_damping` to kMatters, the least stiffness that matters relative to the linear stiffness M.
class NearlyDefinite {
 public:
  explicit NearlyDefinite(const DampingRange& range) : range_(range), sigma_(range.least) {}

  /// Tries larger and larger σ, beginning with the last σ divided by `factor`. Returns the first for which K
  /// + σ M is positive definite, and leaves that matrix factorised. Returns nullopt if K is not nearly
  /// definite.
  std::optional<double> factorise(Problem& problem) {
    for (sigma_ = std::max(range_.least, sigma_ / range_.factor); sigma_ <= kMatters * (1 + kShortest);
         sigma_ *= range_.factor)
      if (problem.factorise(Matrix::exact, sigma_) == Factor::ok) return sigma_;
    sigma_ = range_.least;
    return {};
  }

 private:
  const DampingRange& range_;
  double sigma_;  // shift σ of the last K that was nearly definite
};

}  // namespace netloft::newton
