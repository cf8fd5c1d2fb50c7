// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/statistics.hpp"

#include <span>
#include <vector>

namespace netloft {

/// The matrices of a problem, over the entries of its pattern: the tangent K and its convex part K₊ of the
/// last evaluations that kept them, and the linear stiffness M, the metric, which is evaluated at the start
/// when it is first needed. Solvers ask for sums of them:
///   A + σ M,   A = K, K₊ or 0                                                            (1)
///   K + θ (K₊ − K) + σ M                                                                 (2)
class Matrices {
 public:
  /// Time is counted in `statistics`, which has to outlive this object. No iteration allocates, whichever
  /// matrix it is the first to want; memory that is not wanted is not touched.
  Matrices(Assembler& assembler, Statistics& statistics);

  /// Where an evaluation puts a matrix.
  std::vector<double>& slots(MatrixKind kind);
  /// (1) of NETLOFT_EXACT, NETLOFT_CONVEX or NETLOFT_NONE, valid until the next sum; empty where no
  /// evaluation has kept A.
  std::span<const double> shifted(int matrix, double shift);
  /// (2), likewise.
  std::span<const double> between(double blend, double shift);
  /// y = (1) x over the unknowns. False: there is no such matrix.
  bool multiply(int matrix, double shift, const double* x, double* y);
  /// y[i] = sum of the absolute values in row i of (1), likewise.
  bool row_sums(int matrix, double shift, double* y);

  /// M is there from here on.
  void need_metric();
  /// M is evaluated anew when it is next needed: what elements are made of has changed.
  void forget_metric() {
    metric_.clear();
    diagonal_.clear();
  }
  /// An entry of the diagonal of M, which is there [N/m].
  double metric_at(std::int32_t unknown) const { return diagonal_[static_cast<std::size_t>(unknown)]; }

 private:
  Assembler& assembler_;
  Statistics& statistics_;
  std::vector<double> exact_, convex_, metric_, sum_;
  std::vector<double> diagonal_;  // of the metric
};

}  // namespace netloft
