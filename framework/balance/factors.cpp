// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/factors.hpp"

namespace netloft {

namespace {

MatrixClass class_of(const SparsePattern& pattern, bool may_be_indefinite) {
  if (!pattern.symmetric) return MatrixClass::unsymmetric;
  return may_be_indefinite ? MatrixClass::symmetric : MatrixClass::positive_definite;
}

}  // namespace

netloft_factor Factors::factorise(const SparsePattern& pattern, bool may_be_indefinite,
                                  std::span<const double> values) {
  Factorisation& factorisation = of_class(class_of(pattern, may_be_indefinite), pattern);
  Timed timed(statistics_.factorisation_seconds);
  last_ = &factorisation;
  result_ = factorisation.factorise(values);
  const netloft_factor code = factor_code(result_.status);
  ++statistics_.factorisations;
  statistics_.refused_factorisations += code != NETLOFT_FACTOR_OK;
  return code;
}

Factorisation& Factors::of_class(MatrixClass kind, const SparsePattern& pattern) {
  auto& factorisation = by_class_[static_cast<std::size_t>(kind)];
  if (!factorisation) {
    Timed timed(statistics_.analysis_seconds);
    auto fresh = make_(kind);
    fresh->analyse(pattern);
    factorisation = std::move(fresh);
  }
  return *factorisation;
}

bool Factors::solve(std::span<const double> rhs, std::span<double> x) {
  if (!last_ || result_.status != FactorStatus::ok) return false;
  Timed timed(statistics_.solve_seconds);
  ++statistics_.solves;
  last_->solve(rhs, x);
  return true;
}

bool Factors::solve_transposed(std::span<const double> rhs, std::span<double> x) {
  if (!last_ || result_.status != FactorStatus::ok) return false;
  Timed timed(statistics_.solve_seconds);
  ++statistics_.solves;
  last_->solve_transposed(rhs, x);
  return true;
}

}  // namespace netloft
