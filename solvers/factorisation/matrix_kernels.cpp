// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/matrix_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "framework/simd/registers.hpp"

namespace netloft {
namespace {

using wide::Eight, wide::Four, wide::Two;

template <class Register>
NETLOFT_INLINE void add(const double* x, std::ptrdiff_t count, double* y) {
  using V = typename Register::V;
  std::ptrdiff_t i = 0;
  for (; i + Register::kLanes <= count; i += Register::kLanes)
    *reinterpret_cast<V*>(y + i) += *reinterpret_cast<const V*>(x + i);
  if constexpr (Register::kLanes > 4)
    if (i + 4 <= count) {
      *reinterpret_cast<Four::V*>(y + i) += *reinterpret_cast<const Four::V*>(x + i);
      i += 4;
    }
  if constexpr (Register::kLanes > 2)
    if (i + 2 <= count) {
      *reinterpret_cast<Two::V*>(y + i) += *reinterpret_cast<const Two::V*>(x + i);
      i += 2;
    }
  if (i < count) y[i] += x[i];
}

/// Adds the update of a child to a front: columns of pivots to the left panel, rows of pivots in other
/// columns to the upper panel, and all other numbers to C.
template <class Register>
NETLOFT_INLINE void add_child(const ChildUpdate& child, const FrontPanels& f, double* C) {
  const std::ptrdiff_t n = f.pivots, from = upper_stride(child.others), left = left_stride(n, f.others),
                       stride = upper_stride(f.others);
  for (const UnknownRun& columns : child.runs)
    for (const UnknownRun& rows : child.runs) {
      const double* x = child.C + rows.from + columns.from * from;
      if (columns.place < n) {
        double* y = f.left + rows.place + columns.place * left;
        for (std::int32_t j = 0; j < columns.count; ++j)
          add<Register>(x + j * from, rows.count, y + j * left);
      } else if (rows.place < n) {
        double* y = f.upper + (columns.place - n) + rows.place * stride;
        for (std::int32_t i = 0; i < rows.count; ++i)
          for (std::int32_t j = 0; j < columns.count; ++j) y[i * stride + j] += x[i + j * from];
      } else {
        double* y = C + (rows.place - n) + (columns.place - n) * stride;
        for (std::int32_t j = 0; j < columns.count; ++j)
          add<Register>(x + j * from, rows.count, y + j * stride);
      }
    }
}

/// Copies the numbers. Returns false if some are infinite or NaN, because `sum` is then NaN.
template <class Register>
NETLOFT_INLINE bool take(std::span<const double> from, double* to) {
  using V = typename Register::V;
  constexpr int kApart = 4;  // number of independent sums
  V sum[kApart] = {};
  std::size_t i = 0;
  for (; i + kApart * Register::kLanes <= from.size(); i += kApart * Register::kLanes)
    for (int part = 0; part < kApart; ++part) {
      const std::size_t at = i + static_cast<std::size_t>(part * Register::kLanes);
      const V some = *reinterpret_cast<const V*>(from.data() + at);
      *reinterpret_cast<V*>(to + at) = some;
      sum[part] += some - some;
    }
  double rest = 0;
  for (; i < from.size(); ++i) {
    to[i] = from[i];
    rest += from[i] - from[i];
  }
  return wide::sum_of((sum[0] + sum[1]) + (sum[2] + sum[3])) + rest == 0;
}

template <class Register>
NETLOFT_INLINE void multiply(const MatrixBlocks& A, const double* values, std::span<const double> x,
                             double* products, double* sizes) {
  using V = typename Register::V;
  constexpr int kParts = 8 / Register::kLanes;
  std::fill_n(products, 3 * x.size(), 0.0);
  std::fill_n(sizes, 3 * x.size(), 0.0);
  for (std::size_t c = 0; c + 1 < A.columns.size(); ++c) {
    const double* three = x.data() + A.columns[c].column;
    const Four::V once = {three[0], three[1], three[2], 0};
    const Eight::V all = __builtin_shufflevector(once, once, 0, 1, 2, 0, 1, 2, 0, 1);
    V factor[kParts];
    for (int i = 0; i < kParts; ++i)
      factor[i] = *reinterpret_cast<const V*>(reinterpret_cast<const double*>(&all) + i * Register::kLanes);
    for (std::size_t b = A.columns[c].first; b < A.columns[c + 1].first; ++b) {
      const MatrixBlocks::Block& block = A.blocks[b];
      const double* a = values + block.slot;
      double *product = products + 3 * std::ptrdiff_t{block.row},
             *size = sizes + 3 * std::ptrdiff_t{block.row};
      for (int i = 0; i < kParts; ++i) {
        const V each = *reinterpret_cast<const V*>(a + i * Register::kLanes) * factor[i];
        *reinterpret_cast<V*>(product + i * Register::kLanes) += each;
        *reinterpret_cast<V*>(size + i * Register::kLanes) += each < 0 ? -each : each;
      }
      const double last = a[8] * three[2];
      product[8] += last;
      size[8] += std::abs(last);
    }
  }
  for (const auto& [row, column, slot] : A.entries) {
    const double product = values[slot] * x[static_cast<std::size_t>(column)];
    products[3 * row] += product;
    sizes[3 * row] += std::abs(product);
  }
}

#define NETLOFT_KERNELS(name, Register, ...)                                                                 \
  struct name {                                                                                              \
    __VA_ARGS__ static void add_child(const ChildUpdate& child, const FrontPanels& f, double* C) {           \
      netloft::add_child<Register>(child, f, C);                                                             \
    }                                                                                                        \
    __VA_ARGS__ static bool take(std::span<const double> from, double* to) {                                 \
      return netloft::take<Register>(from, to);                                                              \
    }                                                                                                        \
    __VA_ARGS__ static void multiply(const MatrixBlocks& A, const double* values, std::span<const double> x, \
                                     double* products, double* sizes) {                                      \
      netloft::multiply<Register>(A, values, x, products, sizes);                                            \
    }                                                                                                        \
    static constexpr MatrixKernels all{add_child, take, multiply};                                           \
  };

NETLOFT_KERNELS(Plain, Two, )
NETLOFT_KERNELS(Avx2, Four, NETLOFT_AVX2)
NETLOFT_KERNELS(Avx512, Eight, NETLOFT_AVX512)

}  // namespace

std::vector<MatrixKernels> matrix_kernels_here() {
  return wide::those_here(Plain::all, Avx2::all, Avx512::all);
}

const MatrixKernels& matrix_kernels() {
  static const MatrixKernels best = matrix_kernels_here().back();
  return best;
}

}  // namespace netloft
