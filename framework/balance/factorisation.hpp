// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/sparse_pattern.hpp"

#include <netloft/ext/solver.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace netloft {

/// Properties of a matrix that are known before it is factorised. Only the lower triangle of a positive
/// definite or symmetric matrix is given.
enum class MatrixClass { positive_definite, symmetric, unsymmetric };

enum class FactorStatus { ok, not_positive_definite, singular, out_of_memory, failed };

struct FactorResult {
  FactorStatus status = FactorStatus::ok;
  // Column at which a factorisation stopped, in the caller's numbering; -1: not known.
  std::int32_t column = -1;
  std::int32_t negative_pivots = -1;  // number of negative eigenvalues of a symmetric matrix; -1: not known
};

/// The status as the C interface encodes it.
inline netloft_factor factor_code(FactorStatus status) {
  switch (status) {
    case FactorStatus::ok:
      return NETLOFT_FACTOR_OK;
    case FactorStatus::not_positive_definite:
      return NETLOFT_NOT_POSITIVE;
    case FactorStatus::singular:
      return NETLOFT_SINGULAR;
    default:
      return NETLOFT_FACTOR_FAILED;
  }
}

/// A direct factorisation of one sparse pattern, analysed once and factorised many times.
/// Its implementations are in solvers/factorisation; the framework only counts and times the calls.
class Factorisation {
 public:
  virtual ~Factorisation() = default;

  /// Names of the method, of the library (unless it is our own) and of the ordering, for reports:
  /// "multifrontal LU, METIS on the node graph".
  virtual std::string description() const = 0;

  /// Orders and analyses the pattern, which must outlive this object. Throws std::runtime_error on failure.
  virtual void analyse(const SparsePattern& pattern) = 0;

  /// Factorises `values`, which has pattern.value_slots() entries. A failure discards the previous factor.
  virtual FactorResult factorise(std::span<const double> values) = 0;

  /// Solves with the last successful factor; `rhs` and `x` have `size` entries and may be the same array.
  virtual void solve(std::span<const double> rhs, std::span<double> x) = 0;
  /// The same with the transposed matrix.
  virtual void solve_transposed(std::span<const double> rhs, std::span<double> x) = 0;

  /// Non-zeros of the factor and floating-point operations of one factorisation; 0 if unknown.
  virtual double factor_entries() const { return 0; }
  virtual double factor_flops() const { return 0; }
};

using MakeFactorisation = std::function<std::unique_ptr<Factorisation>(MatrixClass kind)>;

}  // namespace netloft
