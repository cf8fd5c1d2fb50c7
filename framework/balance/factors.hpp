// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"
#include "framework/balance/statistics.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>

namespace netloft {

/// Factorises matrices of one sparsity pattern and solves with the last factor. For each class of matrix
/// (positive definite, symmetric, unsymmetric), a factorisation is created and analysed at its first use.
/// Counts and times every call.
class Factors {
 public:
  /// Counts the calls in `statistics`, which must outlive this object.
  Factors(MakeFactorisation make, Statistics& statistics) : make_(std::move(make)), statistics_(statistics) {}

  /// Factorises the matrix with these values. The pattern must be the same in every call. A symmetric matrix
  /// is expected to be positive definite unless `may_be_indefinite`.
  netloft_factor factorise(const SparsePattern& pattern, bool may_be_indefinite,
                           std::span<const double> values);
  /// Solves with the last factor. Returns false and leaves x unchanged if no factor exists.
  bool solve(std::span<const double> rhs, std::span<double> x);
  /// The same with the transposed matrix.
  bool solve_transposed(std::span<const double> rhs, std::span<double> x);
  void forget() { last_ = nullptr; }
  /// Creates factorisations of other patterns.
  const MakeFactorisation& make() const { return make_; }
  Statistics& statistics() { return statistics_; }

  const FactorResult& last_result() const { return result_; }
  /// Description of the last factorisation, for reports; "none" if there was none.
  std::string description() const { return last_ ? last_->description() : "none"; }

 private:
  Factorisation& of_class(MatrixClass kind, const SparsePattern& pattern);

  MakeFactorisation make_;
  Statistics& statistics_;
  std::array<std::unique_ptr<Factorisation>, 3> by_class_;  // nullptr until first used
  Factorisation* last_ = nullptr;
  FactorResult result_;
};

}  // namespace netloft
