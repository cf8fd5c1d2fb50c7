// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft {

/// The part of the factors that belongs to a front, a dense step of the elimination with n pivots and u other
/// unknowns (front_tree.hpp), stored by columns:
///   left   (n + u) × n   L₁₁\U₁₁ above L₂₁, column stride left_stride(n, u)
///   upper  u × n         U₁₂ᵀ, column stride upper_stride(u)
/// L₁₁\U₁₁ is one square with L₁₁ below and U₁₁ on and above the diagonal. Columns are padded, so that all
/// loops have steps of kTileRows.
struct FrontPanels {
  std::int32_t pivots, others;
  double *left, *upper;
};

constexpr std::ptrdiff_t kTileRows = 8;
constexpr std::ptrdiff_t upper_stride(std::ptrdiff_t others) {
  return (others + kTileRows - 1) / kTileRows * kTileRows;
}
constexpr std::ptrdiff_t left_stride(std::ptrdiff_t pivots, std::ptrdiff_t others) {
  return upper_stride(pivots + others + kTileRows - 1);
}

/// Which pivots are accepted.
struct PivotRule {
  /// Elimination stops if the columns of L₂₁ in one block together have a norm above 1/least.
  double least = 0;
  /// Takes the pivots from the diagonal, without exchange of rows, and stops at the first that is not
  /// positive. With this rule, and except for rounding, the elimination of a symmetric matrix succeeds if and
  /// only if the matrix is positive definite.
  bool positive = false;
};

struct Elimination {
  std::int32_t stopped_at = -1;  // first pivot that is not accepted; -1: none
  bool column_is_zero = false;   // whether the whole column of that pivot is zero
};

/// Number of pivots that are eliminated one by one before the columns after them are updated.
inline constexpr std::ptrdiff_t kPivotBlock = 8;

/// The number n of pivots in one update: the last n pivots before `end` update the next n columns in one
/// product. n is the largest power of two that divides `end`: blocks are merged in pairs, then pairs of pairs
/// and so on.
constexpr std::ptrdiff_t eliminated_together(std::ptrdiff_t end) { return end & -end; }

/// The dense operations on a front, for the instruction set of this processor. A₁₁ is the square of the n
/// pivots; below it are the rows A₂₁ of the u other unknowns, beside it their columns A₁₂; C is the u × u
/// update for the parent front:
///   P A₁₁ = L₁₁ U₁₁,  L₂₁ = A₂₁ U₁₁⁻¹,  U₁₂ = L₁₁⁻¹ P A₁₂                 (1)
///   C ← C − L₂₁ U₁₂                                                       (2)
/// P exchanges rows of A₁₁ only: the largest entry of a column becomes its pivot if the diagonal entry is
/// less than a tenth of the norm of the entries below (threshold pivoting; Duff, Erisman, Reid 1986), unless
/// PivotRule::positive is set.
struct FrontKernels {
  /// Computes (1). `exchanged[k]` becomes the row with which row k was exchanged.
  Elimination (*eliminate)(const FrontPanels& front, const PivotRule& rule, std::int32_t* exchanged);
  /// Computes (2); the columns of C have the stride of `upper`.
  void (*update)(const FrontPanels& front, double* C);
  /// y₁ ← L₁₁⁻¹ y₁, y₂ ← y₂ − L₂₁ y₁, where y consists of y₁, y₂ and kTileRows spare numbers. The caller has
  /// applied P to y.
  void (*forward)(const FrontPanels& front, double* y);
  /// y₁ ← U₁₁⁻¹ (y₁ − U₁₂ y₂). The numbers after y₂ are set to zero.
  void (*backward)(const FrontPanels& front, double* y);
  /// The same for the transposed matrix, whose factors are U and L with P after them:
  /// y₁ ← U₁₁⁻ᵀ y₁, y₂ ← y₂ − U₁₂ᵀ y₁.
  void (*forward_transposed)(const FrontPanels& front, double* y);
  /// y₁ ← L₁₁⁻ᵀ (y₁ − L₂₁ᵀ y₂). The caller applies Pᵀ to y₁. The numbers after y₂ are set to zero.
  void (*backward_transposed)(const FrontPanels& front, double* y);

  // The functions below compute (1) and (2) in pieces for several threads. Pieces for different ranges `from`
  // to `to` are independent. A range of rows begins at a multiple of kTileRows after the first row. The first
  // function computes L₁₁\\U₁₁ and L₂₁ in the columns of one block of pivots.
  Elimination (*eliminate_block)(const FrontPanels& front, std::ptrdiff_t begin, std::ptrdiff_t end,
                                 const PivotRule& rule, std::int32_t* exchanged);
  /// Computes U₁₁ in the rows from `begin` to `end` and the columns from `from` to `to`.
  void (*solve_rows)(const FrontPanels& front, std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t from,
                     std::ptrdiff_t to);
  /// Subtracts the contribution of the pivots from `begin` to `end` from the columns from `end` to `last`, in
  /// the rows from `from` to `to`.
  void (*subtract_rows)(const FrontPanels& front, std::ptrdiff_t begin, std::ptrdiff_t end,
                        std::ptrdiff_t last, std::ptrdiff_t from, std::ptrdiff_t to);
  /// Computes U₁₂ in the columns of the other unknowns from `from` to `to`.
  void (*solve_upper)(const FrontPanels& front, const std::int32_t* exchanged, std::ptrdiff_t from,
                      std::ptrdiff_t to);
  /// Computes (2) in the columns from `from` to `to`.
  void (*update_columns)(const FrontPanels& front, double* C, std::ptrdiff_t from, std::ptrdiff_t to);
};

/// front_kernels() returns the best kernels for this processor, front_kernels_here() all kernels that run on
/// it, the best last.
const FrontKernels& front_kernels();
std::vector<FrontKernels> front_kernels_here();

}  // namespace netloft
