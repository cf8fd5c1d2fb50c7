// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/statistics.hpp"

#include <span>
#include <vector>

namespace netloft {

/// The matrices of a problem, over the entries of its pattern: the tangent K, its convex part K₊ and the
/// metric M. K and K₊ are those of the last evaluation that computed them. M is the linear stiffness at the
/// start of the scene, evaluated at its first use. Solvers use sums of these matrices:
///   A + σ M,   A = K, K₊ or 0                                                            (1)
///   K + θ (K₊ − K) + σ M                                                                 (2)
class Matrices {
 public:
  /// Counts time in `statistics`, which has to outlive this object. Reserves memory for every matrix, so that
  /// no iteration allocates; memory of matrices that nobody uses is never touched.
  Matrices(Assembler& assembler, Statistics& statistics);

  /// Storage in which an evaluation writes a matrix.
  std::vector<double>& slots(MatrixKind kind);
  /// The sum (1) with A chosen by NETLOFT_EXACT, NETLOFT_CONVEX or NETLOFT_NONE. It is valid until the next
  /// sum, and empty if A has not been evaluated.
  std::span<const double> shifted(int matrix, double shift);
  /// The sum (2). It is valid until the next sum, and empty if K or K₊ has not been evaluated.
  std::span<const double> between(double blend, double shift);
  /// y = (1) x over the unknowns. Returns false if A has not been evaluated.
  bool multiply(int matrix, double shift, const double* x, double* y);
  /// y[i] = sum of the absolute values in row i of (1). Returns false if A has not been evaluated.
  bool row_sums(int matrix, double shift, double* y);

  /// Evaluates M unless this was done before.
  void need_metric();
  /// Discards M, because the properties of elements have changed. It is evaluated again at its next use.
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
  std::vector<double> diagonal_;  // of the metric
};

}  // namespace netloft
