// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/statistics.hpp"

#include <span>
#include <utility>
#include <vector>

namespace netloft {

/// The matrices of a problem: the tangent K, its convex part K₊ (positive semi-definite) and the metric M. K
/// and K₊ come from the last evaluation that computed them. M is the linear stiffness at the start of the
/// scene, evaluated at its first use. Solvers use sums of these matrices:
///   A + σ M,   A = K, K₊ or 0                                                            (1)
///   K + θ (K₊ − K) + σ M                                                                 (2)
class Matrices {
 public:
  /// Counts time in `statistics`, which must outlive this object. Reserves memory for all matrices, so that
  /// no iteration allocates. The operating system provides this memory only when it is used.
  Matrices(Assembler& assembler, Statistics& statistics);

  /// The array to which an evaluation writes the values of a matrix.
  std::vector<double>& slots(MatrixKind kind);
  /// Computes the sum (1), where `matrix` selects A: NETLOFT_EXACT, NETLOFT_CONVEX or NETLOFT_NONE. The
  /// result is valid until the next sum, and empty if A has not been evaluated.
  std::span<const double> shifted(int matrix, double shift);
  /// Computes the sum (2) with θ = `blend`. The result is valid until the next sum, and empty if K or K₊ has
  /// not been evaluated.
  std::span<const double> between(double blend, double shift);
  /// Computes y = (A + σ M) x. Returns false if A has not been evaluated.
  bool multiply(int matrix, double shift, const double* x, double* y);
  /// Computes y = Aᵀ x. Returns false if A has not been evaluated.
  bool multiply_transposed(int matrix, const double* x, double* y);
  /// Computes y[i] = sum of the absolute values in row i of A + σ M. Returns false if A has not been
  /// evaluated.
  bool row_sums(int matrix, double shift, double* y);

  /// Moves the array of a matrix to the caller, who can reuse the memory of the array. The matrix has to be
  /// evaluated again before its next use.
  std::vector<double> give_away(MatrixKind kind) { return std::exchange(slots(kind), {}); }

  /// Evaluates the linear stiffness M if this has not been done yet.
  void need_metric();
  /// Discards M, because the properties of elements have changed. M is evaluated again at its next use.
  void forget_metric() {
    metric_.clear();
    diagonal_.clear();
  }
  /// Entry on the diagonal of M, which must have been evaluated [N/m].
  double metric_at(std::int32_t unknown) const { return diagonal_[static_cast<std::size_t>(unknown)]; }

 private:
  Assembler& assembler_;
  Statistics& statistics_;
  std::vector<double> exact_, convex_, metric_, sum_;
  std::vector<double> diagonal_;  // diagonal of the metric
};

}  // namespace netloft
