// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"
#include "framework/balance/statistics.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>

namespace netloft {

/// Factorises matrices of one pattern, and solves with the last of them: a factorisation for each class of
/// matrix, made and analysed when it is first wanted. Counts and times every call.
class Factors {
 public:
  /// Calls are counted in `statistics`, which has to outlive this object.
  Factors(MakeFactorisation make, Statistics& statistics) : make_(std::move(make)), statistics_(statistics) {}

  /// Factorises `values` over the entries of the pattern, which stays the same. A symmetric matrix is taken
  /// for positive definite unless it may be indefinite.
  netloft_factor factorise(const SparsePattern& pattern, bool may_be_indefinite,
                           std::span<const double> values);
  /// Solves with the last factor. False: there is none, and x is not touched.
  bool solve(std::span<const double> rhs, std::span<double> x);
  /// As if nothing had been factorised before.
  void forget() { last_ = nullptr; }

  const FactorResult& last_result() const { return result_; }
  /// What the last factorisation is, for people; "none" without.
  std::string description() const { return last_ ? last_->description() : "none"; }

 private:
  Factorisation& of_class(MatrixClass kind, const SparsePattern& pattern);

  MakeFactorisation make_;
  Statistics& statistics_;
  std::array<std::unique_ptr<Factorisation>, 3> by_class_;  // null until wanted
  Factorisation* last_ = nullptr;
  FactorResult result_;
};

}  // namespace netloft
