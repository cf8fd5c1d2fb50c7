// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/symmetric_front.hpp"

#include <algorithm>

#include "solvers/factorisation/shared_front.hpp"

namespace netloft {
namespace {

// No pivot of a positive definite matrix has to be exchanged, however small it is (Higham 2002, ch. 10).
constexpr PivotRule kAllOnTheDiagonal{.suits = 0, .least = 0};
constexpr std::ptrdiff_t kColumns =
    6 * kTileRows;  // of a piece of the triangle: whole tiles of every instruction set

/// U₁₁ needs the upper triangle of A₁₁, too.
void mirror(const FrontPanels& f) {
  const std::ptrdiff_t n = f.pivots, across = left_stride(n, f.others);
  for (std::ptrdiff_t k = 0; k < n; ++k)
    for (std::ptrdiff_t i = k + 1; i < n; ++i) f.left[k + i * across] = f.left[i + k * across];
}

/// (3)
void set_upper(const FrontPanels& f) {
  const std::ptrdiff_t n = f.pivots, across = left_stride(n, f.others), stride = upper_stride(f.others);
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const double *below = f.left + n + k * across, pivot = f.left[k + k * across];
    for (std::ptrdiff_t i = 0; i < f.others; ++i) f.upper[i + k * stride] = below[i] * pivot;
  }
}

/// A pivot of zero would have been exchanged.
std::int32_t first_not_positive(const FrontPanels& f, const std::int32_t* exchanged) {
  const std::ptrdiff_t across = left_stride(f.pivots, f.others);
  for (std::int32_t k = 0; k < f.pivots; ++k)
    if (exchanged[k] != k || !(f.left[k + k * across] > 0)) return k;
  return -1;
}

}  // namespace

Elimination eliminate_symmetric(const FrontKernels& kernels, const FrontPanels& f, std::int32_t* exchanged,
                                Workers* workers) {
  mirror(f);
  Elimination e = workers ? eliminate_left_together(kernels, f, kAllOnTheDiagonal, exchanged, *workers)
                          : kernels.eliminate_left(f, kAllOnTheDiagonal, exchanged);
  if (e.stopped_at < 0) e.stopped_at = first_not_positive(f, exchanged);
  if (e.stopped_at < 0) set_upper(f);
  return e;
}

void update_symmetric(const FrontKernels& kernels, const FrontPanels& f, double* C, Workers* workers) {
  const std::ptrdiff_t pieces = (f.others + kColumns - 1) / kColumns;
  const auto update = [&](std::size_t, std::size_t piece) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(piece) * kColumns;
    kernels.update_columns(f, C, from, from, std::min<std::ptrdiff_t>(from + kColumns, f.others));
  };
  if (workers) return workers->run(static_cast<std::size_t>(pieces), 2, update);
  for (std::ptrdiff_t piece = 0; piece < pieces; ++piece) update(0, static_cast<std::size_t>(piece));
}

}  // namespace netloft
