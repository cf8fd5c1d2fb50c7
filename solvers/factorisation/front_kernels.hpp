// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft {

/// What a front of n pivots and u other unknowns leaves in the factors, by columns:
///   left   (n + u) × n   L₁₁\U₁₁ above L₂₁, column stride left_stride(n, u)
///   upper  u × n         U₁₂ᵀ, column stride upper_stride(u)
/// Columns are longer than their contents, so that all loops go in steps of kTileRows.
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

/// How the elimination of a front ended.
struct Elimination {
  std::int32_t stopped_at = -1;  // pivot that is zero, or too small as one up to this; -1: none
  bool column_is_zero = false;   // and so is all of its column
};

/// The dense work on a front, for the instructions this processor has:
///   P A₁₁ = L₁₁ U₁₁,  L₂₁ = A₂₁ U₁₁⁻¹,  U₁₂ = L₁₁⁻¹ P A₁₂                 (1)
///   C ← C − L₂₁ U₁₂                                                       (2)
/// P exchanges rows of A₁₁ alone: the largest entry of a column becomes its pivot where the one on the
/// diagonal is less than a tenth of the norm of those below (threshold pivoting; Duff, Erisman, Reid 1986).
/// It stops where some columns of L₂₁ together have a norm of more than 1/least_pivot.
struct FrontKernels {
  /// (1); `exchanged[k]` is the row that row k was exchanged with.
  Elimination (*eliminate)(const FrontPanels& front, double least_pivot, std::int32_t* exchanged);
  /// (2); the columns of C have the stride of `upper`.
  void (*update)(const FrontPanels& front, double* C);
  /// y₁ ← L₁₁⁻¹ y₁, y₂ ← y₂ − L₂₁ y₁, with y = (y₁, y₂) and kTileRows more; P has been done.
  void (*forward)(const FrontPanels& front, double* y);
  /// y₁ ← U₁₁⁻¹ (y₁ − U₁₂ y₂); what comes behind y₂ is set to zero.
  void (*backward)(const FrontPanels& front, double* y);
};

/// The best there is, and all that run here, the best last.
const FrontKernels& front_kernels();
std::vector<FrontKernels> front_kernels_here();

}  // namespace netloft
