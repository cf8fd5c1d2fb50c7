// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "framework/simd/registers.hpp"

namespace netloft {
namespace {

using wide::Eight, wide::Four, wide::Two;

// If a pivot is at least this fraction of the norm of the entries below it, it is accepted without exchanging
// rows.
constexpr double kSuits = 0.1;
constexpr std::ptrdiff_t kBlock = kPivotBlock;

/// The number of columns of a tile (a small block of the product) for which its sums and a column of A fit
/// into the registers.
template <class Register>
constexpr int kTileColumns = Register::kLanes == 2   ? 3
                             : Register::kLanes == 4 ? 6
                                                     : 8;

/// A matrix whose entry (p, j) is at[p·down + j·across].
struct Factor {
  const double* at;
  std::ptrdiff_t down, across;
};

template <class Register, int kColumns>
NETLOFT_INLINE void subtract_tile(std::ptrdiff_t k, const double* a, std::ptrdiff_t lda, Factor b, double* c,
                                  std::ptrdiff_t ldc) {
  constexpr int kParts = static_cast<int>(kTileRows) / Register::kLanes;
  typename Register::V sum[kColumns][kParts];
  for (int j = 0; j < kColumns; ++j)
    for (int i = 0; i < kParts; ++i)
      sum[j][i] = *reinterpret_cast<const typename Register::V*>(c + j * ldc + i * Register::kLanes);
  for (std::ptrdiff_t p = 0; p < k; ++p, a += lda, b.at += b.down) {
    typename Register::V column[kParts];
    for (int i = 0; i < kParts; ++i)
      column[i] = *reinterpret_cast<const typename Register::V*>(a + i * Register::kLanes);
    for (int j = 0; j < kColumns; ++j)
      for (int i = 0; i < kParts; ++i) sum[j][i] -= column[i] * b.at[j * b.across];
  }
  for (int j = 0; j < kColumns; ++j)
    for (int i = 0; i < kParts; ++i)
      *reinterpret_cast<typename Register::V*>(c + j * ldc + i * Register::kLanes) = sum[j][i];
}

template <class Register, int kColumns>
NETLOFT_INLINE void subtract_columns(std::ptrdiff_t m, std::ptrdiff_t k, const double* a, std::ptrdiff_t lda,
                                     Factor b, double* c, std::ptrdiff_t ldc) {
  for (std::ptrdiff_t i = 0; i < m; i += kTileRows)
    subtract_tile<Register, kColumns>(k, a + i, lda, b, c + i, ldc);
}

/// Computes C ← C − A B, where C has m × n numbers and A has k columns. m is rounded up to a multiple of
/// kTileRows.
template <class Register>
NETLOFT_INLINE void subtract_product(std::ptrdiff_t m, std::ptrdiff_t n, std::ptrdiff_t k, const double* a,
                                     std::ptrdiff_t lda, Factor b, double* c, std::ptrdiff_t ldc) {
  constexpr int kColumns = kTileColumns<Register>;
  std::ptrdiff_t j = 0;
  for (; j + kColumns <= n; j += kColumns, b.at += kColumns * b.across)
    subtract_columns<Register, kColumns>(m, k, a, lda, b, c + j * ldc, ldc);
  for (; j + 4 <= n; j += 4, b.at += 4 * b.across)
    subtract_columns<Register, 4>(m, k, a, lda, b, c + j * ldc, ldc);
  for (; j + 2 <= n; j += 2, b.at += 2 * b.across)
    subtract_columns<Register, 2>(m, k, a, lda, b, c + j * ldc, ldc);
  if (j < n) subtract_columns<Register, 1>(m, k, a, lda, b, c + j * ldc, ldc);
}

/// Computes X ← X S T⁻¹ row by row in the registers, with a diagonal S and a unit upper triangular T of
/// kWidth columns. Adds the squares of all numbers of the new X to `squares`. The number of rows is rounded
/// up to a multiple of kTileRows.
template <class Register, int kWidth>
NETLOFT_INLINE void solve_rows_of_block(std::ptrdiff_t rows, double* x, std::ptrdiff_t stride, Factor T,
                                        const double* S, double& squares) {
  using V = typename Register::V;
  V sum = {};
  for (std::ptrdiff_t i = 0; i < rows; i += Register::kLanes) {
    V row[kWidth];
    for (int j = 0; j < kWidth; ++j) row[j] = *reinterpret_cast<const V*>(x + i + j * stride);
    for (int k = 0; k < kWidth; ++k) {
      row[k] *= S[k];
      sum += row[k] * row[k];
      for (int j = k + 1; j < kWidth; ++j) row[j] -= row[k] * T.at[k * T.down + j * T.across];
    }
    for (int j = 0; j < kWidth; ++j) *reinterpret_cast<V*>(x + i + j * stride) = row[j];
  }
  for (int lane = 0; lane < Register::kLanes; ++lane) squares += sum[lane];
}

template <class Register>
NETLOFT_INLINE void solve_block(std::ptrdiff_t width, std::ptrdiff_t rows, double* x, std::ptrdiff_t stride,
                                Factor T, const double* S, double& squares) {
  switch (width) {
    case 1:
      return solve_rows_of_block<Register, 1>(rows, x, stride, T, S, squares);
    case 2:
      return solve_rows_of_block<Register, 2>(rows, x, stride, T, S, squares);
    case 3:
      return solve_rows_of_block<Register, 3>(rows, x, stride, T, S, squares);
    case 4:
      return solve_rows_of_block<Register, 4>(rows, x, stride, T, S, squares);
    case 5:
      return solve_rows_of_block<Register, 5>(rows, x, stride, T, S, squares);
    case 6:
      return solve_rows_of_block<Register, 6>(rows, x, stride, T, S, squares);
    case 7:
      return solve_rows_of_block<Register, 7>(rows, x, stride, T, S, squares);
    default:
      return solve_rows_of_block<Register, 8>(rows, x, stride, T, S, squares);
  }
}

/// Ones between zeros, from which kernels read masks of kTileRows numbers: zeros followed by ones, or ones
/// followed by zeros.
constexpr double kOnesBetween[3 * kTileRows] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1,
                                                1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};

/// The kTileRows factors of the rows from `row` on: 1 for rows beyond k and before n, 0 for all others.
/// (Compilers do not vectorise comparisons of vectors.)
struct OwnRows {
  NETLOFT_INLINE OwnRows(std::ptrdiff_t row, std::ptrdiff_t k, std::ptrdiff_t n)
      : beyond(kOnesBetween + kTileRows - std::clamp<std::ptrdiff_t>(k + 1 - row, 0, kTileRows)),
        before(kOnesBetween + 2 * kTileRows - std::clamp<std::ptrdiff_t>(n - row, 0, kTileRows)) {}
  template <class Register>
  NETLOFT_INLINE void keep(std::ptrdiff_t i, typename Register::V& rows) const {
    using V = typename Register::V;
    rows *= *reinterpret_cast<const V*>(beyond + i) * *reinterpret_cast<const V*>(before + i);
  }
  const double *beyond, *before;
};

/// Whether entry k of a column can be the pivot without exchanging rows, because it is large enough compared
/// with the entries below it, down to row n.
template <class Register>
NETLOFT_INLINE bool is_pivot(const double* column, std::ptrdiff_t begin, std::ptrdiff_t k, std::ptrdiff_t n) {
  using V = typename Register::V;
  V squares = {};
  for (std::ptrdiff_t i = begin; i < n; i += kTileRows) {
    const OwnRows own(i, k, n);
    for (std::ptrdiff_t part = 0; part < kTileRows; part += Register::kLanes) {
      V rows = *reinterpret_cast<const V*>(column + i + part);
      own.keep<Register>(part, rows);
      squares += rows * rows;
    }
  }
  const double sum = wide::sum_of(squares);
  const double square = column[k] * column[k];
  return square > 0 && square >= kSuits * kSuits * sum;
}

NETLOFT_INLINE std::ptrdiff_t row_of_largest(const double* column, std::ptrdiff_t from, std::ptrdiff_t to) {
  std::ptrdiff_t row = from;
  for (std::ptrdiff_t i = from + 1; i < to; ++i)
    if (std::abs(column[i]) > std::abs(column[row])) row = i;
  return row;
}

NETLOFT_INLINE void exchange(double* x, double* y, std::ptrdiff_t count, std::ptrdiff_t stride) {
  for (std::ptrdiff_t i = 0; i < count * stride; i += stride) {
    const double kept = x[i];
    x[i] = y[i];
    y[i] = kept;
  }
}

NETLOFT_INLINE void subtract(double a, const double* x, std::ptrdiff_t count, double* y) {
  for (std::ptrdiff_t i = 0; i < count; ++i) y[i] -= a * x[i];
}

/// Computes a column of L below its pivot k, in the rows before n, and subtracts its contribution from the
/// following columns before `end`. All pivots of a block use the same tiles of rows, so that the processor
/// reads every tile with the width with which it wrote the tile. Returns one over the pivot.
template <class Register>
NETLOFT_INLINE double eliminate_column(double* left, std::ptrdiff_t stride, std::ptrdiff_t begin,
                                       std::ptrdiff_t k, std::ptrdiff_t n, std::ptrdiff_t end) {
  using V = typename Register::V;
  double *column = left + k * stride, U[kBlock];
  const double reciprocal = 1 / column[k];
  for (std::ptrdiff_t j = k + 1; j < end; ++j) U[j - k - 1] = left[k + j * stride];
  for (std::ptrdiff_t i = begin; i < n; i += kTileRows) {
    const OwnRows own(i, k, n);
    for (std::ptrdiff_t part = 0; part < kTileRows; part += Register::kLanes) {
      V& rows = *reinterpret_cast<V*>(column + i + part);
      V L = rows;
      own.keep<Register>(part, L);
      rows -= L;
      L *= reciprocal;
      rows += L;
      for (std::ptrdiff_t j = k + 1; j < end; ++j)
        *reinterpret_cast<V*>(left + i + part + j * stride) -= L * U[j - k - 1];
    }
  }
  return reciprocal;
}

/// Eliminates pivot k of the block that begins at `begin`, within the rows of A₁₁: exchanges rows if
/// necessary, computes column k of L, and updates the columns after k and before `end`. Returns one over the
/// pivot, or zero if the pivot is not accepted.
template <class Register>
NETLOFT_INLINE double eliminate_pivot(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t k,
                                      std::ptrdiff_t end, bool positive, std::int32_t* exchanged) {
  const std::ptrdiff_t n = f.pivots, stride = left_stride(n, f.others);
  const double* column = f.left + k * stride;
  if (positive && !(column[k] > 0)) return 0;
  const std::ptrdiff_t row =
      positive || is_pivot<Register>(column, begin, k, n) ? k : row_of_largest(column, k, n);
  if (column[row] == 0) return 0;
  exchanged[k] = static_cast<std::int32_t>(row);
  if (row != k) exchange(f.left + k, f.left + row, n, stride);
  return eliminate_column<Register>(f.left, stride, begin, k, n, end);
}

/// Computes L₂₁ (front_kernels.hpp (1)) in the columns from `begin` to `end`. S contains the reciprocals of
/// the pivots of these columns. Returns the sum of the squares of the computed numbers.
template <class Register>
NETLOFT_INLINE double solve_below(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t end,
                                  const double* S) {
  const std::ptrdiff_t stride = left_stride(f.pivots, f.others);
  double squares = 0;
  solve_block<Register>(end - begin, f.others, f.left + f.pivots + begin * stride, stride,
                        {f.left + begin + begin * stride, 1, stride}, S, squares);
  return squares;
}

/// Whether column k of A₂₁ (the rows below the pivots) is zero after the columns from `begin` to k have been
/// eliminated.
template <class Register>
NETLOFT_INLINE bool is_zero_below(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t k,
                                  const double* S) {
  const std::ptrdiff_t stride = left_stride(f.pivots, f.others);
  if (k > begin) solve_below<Register>(f, begin, k, S);
  double* column = f.left + f.pivots + k * stride;
  for (std::ptrdiff_t j = begin; j < k; ++j)
    subtract(f.left[j + k * stride], f.left + f.pivots + j * stride, f.others, column);
  for (std::ptrdiff_t i = 0; i < f.others; ++i)
    if (column[i] != 0) return false;
  return true;
}

template <class Register>
NETLOFT_INLINE Elimination eliminate_block(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t end,
                                           const PivotRule& rule, std::int32_t* exchanged) {
  double S[kBlock];
  for (std::ptrdiff_t k = begin; k < end; ++k) {
    S[k - begin] = eliminate_pivot<Register>(f, begin, k, end, rule.positive, exchanged);
    if (S[k - begin] == 0) return {static_cast<std::int32_t>(k), is_zero_below<Register>(f, begin, k, S)};
  }
  const double squares = solve_below<Register>(f, begin, end, S);
  if (!(rule.least * rule.least * squares < 1)) return {static_cast<std::int32_t>(end - 1), false};
  return {};
}

/// Computes C ← L⁻¹ C with a unit lower triangular L of kBlock columns, and C with `columns` columns of the
/// same stride.
template <class Register>
NETLOFT_INLINE void solve_lower(const double* L, std::ptrdiff_t stride, double* c, std::ptrdiff_t columns) {
  using V = typename Register::V;
  constexpr int kParts = static_cast<int>(kBlock) / Register::kLanes;
  V below[kBlock][kParts];
  for (int k = 0; k < kBlock; ++k)
    for (int i = 0; i < kParts; ++i) {
      below[k][i] = *reinterpret_cast<const V*>(L + k * stride + i * Register::kLanes);
      OwnRows(0, k, kBlock).keep<Register>(i * Register::kLanes, below[k][i]);
    }
  for (std::ptrdiff_t j = 0; j < columns; ++j, c += stride) {
    V rows[kParts];
    for (int i = 0; i < kParts; ++i) rows[i] = *reinterpret_cast<const V*>(c + i * Register::kLanes);
#pragma GCC unroll 8
    for (int k = 0; k < kBlock; ++k) {
      const double known = rows[k / Register::kLanes][k % Register::kLanes];
      for (int i = 0; i < kParts; ++i) rows[i] -= below[k][i] * known;
    }
    for (int i = 0; i < kParts; ++i) *reinterpret_cast<V*>(c + i * Register::kLanes) = rows[i];
  }
}

/// Computes U in the rows from `begin` to `end` and the columns from `from` to `to`.
template <class Register>
NETLOFT_INLINE void solve_rows(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t end,
                               std::ptrdiff_t from, std::ptrdiff_t to) {
  const std::ptrdiff_t stride = left_stride(f.pivots, f.others);
  for (; begin < end; begin += kBlock) {
    const std::ptrdiff_t next = begin + kBlock;
    solve_lower<Register>(f.left + begin + begin * stride, stride, f.left + begin + from * stride, to - from);
    subtract_product<Register>(end - next, to - from, kBlock, f.left + next + begin * stride, stride,
                               {f.left + begin + from * stride, 1, stride}, f.left + next + from * stride,
                               stride);
  }
}

/// Subtracts the product L U of the pivots from `begin` to `end`, in the columns from `end` to `last` and the
/// rows from `from` to `to`.
template <class Register>
NETLOFT_INLINE void subtract_rows(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t end,
                                  std::ptrdiff_t last, std::ptrdiff_t from, std::ptrdiff_t to) {
  const std::ptrdiff_t stride = left_stride(f.pivots, f.others);
  subtract_product<Register>(to - from, last - end, end - begin, f.left + from + begin * stride, stride,
                             {f.left + begin + end * stride, 1, stride}, f.left + from + end * stride,
                             stride);
}

template <class Register>
NETLOFT_INLINE Elimination eliminate_left(const FrontPanels& f, const PivotRule& rule,
                                          std::int32_t* exchanged) {
  const std::ptrdiff_t n = f.pivots, rows = n + f.others;
  for (std::ptrdiff_t done = 0; done < n;) {
    const std::ptrdiff_t end = std::min(done + kBlock, n);
    if (const Elimination e = eliminate_block<Register>(f, done, end, rule, exchanged); e.stopped_at >= 0)
      return e;
    done = end;
    if (end == n) break;
    const std::ptrdiff_t width = eliminated_together(end), begin = end - width,
                         last = std::min(end + width, n);
    solve_rows<Register>(f, begin, end, end, last);
    subtract_rows<Register>(f, begin, end, last, end, rows);
  }
  return {};
}

/// Computes U₁₂ in the columns of the other unknowns from `from` to `to`.
template <class Register>
NETLOFT_INLINE void solve_upper(const FrontPanels& f, const std::int32_t* exchanged, std::ptrdiff_t from,
                                std::ptrdiff_t to) {
  const std::ptrdiff_t n = f.pivots, u = to - from, across = left_stride(n, f.others),
                       stride = upper_stride(f.others);
  constexpr double kOnes[kBlock] = {1, 1, 1, 1, 1, 1, 1, 1};
  double unused = 0, *const upper = f.upper + from;
  for (std::ptrdiff_t k = 0; k < n; ++k)
    if (exchanged[k] != k) exchange(upper + k * stride, upper + exchanged[k] * stride, u, 1);
  for (std::ptrdiff_t done = 0; done < n;) {
    const std::ptrdiff_t end = std::min(done + kBlock, n);
    solve_block<Register>(end - done, u, upper + done * stride, stride,
                          {f.left + done + done * across, across, 1}, kOnes, unused);
    done = end;
    const std::ptrdiff_t width = eliminated_together(end), begin = end - width,
                         last = std::min(end + width, n);
    if (end < n)
      subtract_product<Register>(u, last - end, width, upper + begin * stride, stride,
                                 {f.left + end + begin * across, across, 1}, upper + end * stride, stride);
  }
}

template <class Register>
NETLOFT_INLINE Elimination eliminate(const FrontPanels& f, const PivotRule& rule, std::int32_t* exchanged) {
  const Elimination e = eliminate_left<Register>(f, rule, exchanged);
  if (e.stopped_at < 0) solve_upper<Register>(f, exchanged, 0, f.others);
  return e;
}

template <class Register>
NETLOFT_INLINE void update(const FrontPanels& f, double* C, std::ptrdiff_t from, std::ptrdiff_t to) {
  const std::ptrdiff_t n = f.pivots, u = f.others, stride = upper_stride(u);
  subtract_product<Register>(u, to - from, n, f.left + n, left_stride(n, u), {f.upper + from, stride, 1},
                             C + from * stride, stride);
}

template <class Register>
NETLOFT_INLINE void forward(const FrontPanels& f, double* y) {
  const std::ptrdiff_t n = f.pivots, rows = n + f.others, stride = left_stride(n, f.others);
  for (std::ptrdiff_t begin = 0; begin < n; begin += kBlock) {
    const std::ptrdiff_t end = std::min(begin + kBlock, n);
    for (std::ptrdiff_t k = begin; k < end; ++k)
      subtract(y[k], f.left + k * stride + k + 1, end - k - 1, y + k + 1);
    subtract_columns<Register, 1>(rows - end, end - begin, f.left + end + begin * stride, stride,
                                  {y + begin, 1, 0}, y + end, 0);
  }
}

/// Computes y ← y − Aᵀ x for a matrix A of kColumns columns. `rows` is rounded up to a multiple of kTileRows.
template <class Register, int kColumns>
NETLOFT_INLINE void subtract_dots(const double* a, std::ptrdiff_t stride, std::ptrdiff_t rows,
                                  const double* x, double* y) {
  using V = typename Register::V;
  V sum[kColumns] = {};
  for (std::ptrdiff_t i = 0; i < upper_stride(rows); i += Register::kLanes)
    for (int j = 0; j < kColumns; ++j)
      sum[j] += *reinterpret_cast<const V*>(a + j * stride + i) * *reinterpret_cast<const V*>(x + i);
  for (int j = 0; j < kColumns; ++j) y[j] -= wide::sum_of(sum[j]);
}

/// The same for `columns` columns.
template <class Register>
NETLOFT_INLINE void subtract_all_dots(std::ptrdiff_t columns, const double* a, std::ptrdiff_t stride,
                                      std::ptrdiff_t rows, const double* x, double* y) {
  std::ptrdiff_t k = 0;
  for (; k + 4 <= columns; k += 4) subtract_dots<Register, 4>(a + k * stride, stride, rows, x, y + k);
  for (; k < columns; ++k) subtract_dots<Register, 1>(a + k * stride, stride, rows, x, y + k);
}

/// Computes y ← U⁻¹ y for an upper triangular U of `width` columns, at most kBlock, with y in registers.
template <class Register>
NETLOFT_INLINE void solve_upper_triangle(const double* U, std::ptrdiff_t stride, std::ptrdiff_t width,
                                         double* y) {
  using V = typename Register::V;
  constexpr int kParts = static_cast<int>(kBlock) / Register::kLanes;
  double reciprocal[kBlock] = {1, 1, 1, 1, 1, 1, 1, 1}, known[kBlock] = {};
  for (std::ptrdiff_t k = 0; k < width; ++k) reciprocal[k] = U[k + k * stride];
  for (double& pivot : reciprocal) pivot = 1 / pivot;
  V rows[kParts];
  for (int i = 0; i < kParts; ++i) rows[i] = *reinterpret_cast<const V*>(y + i * Register::kLanes);
#pragma GCC unroll 8
  for (int k = static_cast<int>(kBlock) - 1; k >= 0; --k) {
    if (k >= width) continue;
    known[k] = rows[k / Register::kLanes][k % Register::kLanes] * reciprocal[k];
    for (int i = 0; i < kParts; ++i) {
      V above = *reinterpret_cast<const V*>(U + k * stride + i * Register::kLanes);
      OwnRows(0, -1, k).keep<Register>(i * Register::kLanes, above);
      rows[i] -= above * known[k];
    }
  }
  for (std::ptrdiff_t k = 0; k < width; ++k) y[k] = known[k];
}

template <class Register>
NETLOFT_INLINE void backward(const FrontPanels& f, double* y) {
  const std::ptrdiff_t n = f.pivots, u = f.others, stride = upper_stride(u), down = left_stride(n, u);
  std::fill_n(y + n + u, kTileRows, 0.0);
  subtract_all_dots<Register>(n, f.upper, stride, u, y + n, y);
  for (std::ptrdiff_t end = n, begin = 0; end > 0; end = begin) {
    begin = (end - 1) / kBlock * kBlock;
    solve_upper_triangle<Register>(f.left + begin + begin * down, down, end - begin, y + begin);
    subtract_columns<Register, 1>(begin, end - begin, f.left + begin * down, down, {y + begin, 1, 0}, y, 0);
  }
}

template <class Register>
NETLOFT_INLINE void forward_transposed(const FrontPanels& f, double* y) {
  const std::ptrdiff_t n = f.pivots, down = left_stride(n, f.others);
  for (std::ptrdiff_t begin = 0; begin < n; begin += kBlock) {
    const std::ptrdiff_t end = std::min(begin + kBlock, n);
    subtract_all_dots<Register>(end - begin, f.left + begin * down, down, begin, y, y + begin);
    for (std::ptrdiff_t k = begin; k < end; ++k) {
      const double* column = f.left + k * down;
      for (std::ptrdiff_t i = begin; i < k; ++i) y[k] -= column[i] * y[i];
      y[k] /= column[k];
    }
  }
  subtract_columns<Register, 1>(f.others, n, f.upper, upper_stride(f.others), {y, 1, 0}, y + n, 0);
}

template <class Register>
NETLOFT_INLINE void backward_transposed(const FrontPanels& f, double* y) {
  const std::ptrdiff_t n = f.pivots, rows = n + f.others, down = left_stride(n, f.others);
  std::fill_n(y + rows, kTileRows, 0.0);
  for (std::ptrdiff_t end = n, begin = 0; end > 0; end = begin) {
    begin = (end - 1) / kBlock * kBlock;
    subtract_all_dots<Register>(end - begin, f.left + end + begin * down, down, rows - end, y + end,
                                y + begin);
    for (std::ptrdiff_t k = end - 1; k >= begin; --k)
      for (std::ptrdiff_t i = k + 1; i < end; ++i) y[k] -= f.left[i + k * down] * y[i];
  }
}

#define NETLOFT_KERNELS(name, Register, ...)                                                                 \
  struct name {                                                                                              \
    __VA_ARGS__ static Elimination eliminate(const FrontPanels& f, const PivotRule& rule,                    \
                                             std::int32_t* exchanged) {                                      \
      return netloft::eliminate<Register>(f, rule, exchanged);                                               \
    }                                                                                                        \
    __VA_ARGS__ static void update(const FrontPanels& f, double* C) {                                        \
      netloft::update<Register>(f, C, 0, f.others);                                                          \
    }                                                                                                        \
    __VA_ARGS__ static void forward(const FrontPanels& f, double* y) { netloft::forward<Register>(f, y); }   \
    __VA_ARGS__ static void backward(const FrontPanels& f, double* y) { netloft::backward<Register>(f, y); } \
    __VA_ARGS__ static void forward_transposed(const FrontPanels& f, double* y) {                            \
      netloft::forward_transposed<Register>(f, y);                                                           \
    }                                                                                                        \
    __VA_ARGS__ static void backward_transposed(const FrontPanels& f, double* y) {                           \
      netloft::backward_transposed<Register>(f, y);                                                          \
    }                                                                                                        \
    __VA_ARGS__ static Elimination eliminate_block(const FrontPanels& f, std::ptrdiff_t begin,               \
                                                   std::ptrdiff_t end, const PivotRule& rule,                \
                                                   std::int32_t* exchanged) {                                \
      return netloft::eliminate_block<Register>(f, begin, end, rule, exchanged);                             \
    }                                                                                                        \
    __VA_ARGS__ static void solve_rows(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t end,       \
                                       std::ptrdiff_t from, std::ptrdiff_t to) {                             \
      netloft::solve_rows<Register>(f, begin, end, from, to);                                                \
    }                                                                                                        \
    __VA_ARGS__ static void subtract_rows(const FrontPanels& f, std::ptrdiff_t begin, std::ptrdiff_t end,    \
                                          std::ptrdiff_t last, std::ptrdiff_t from, std::ptrdiff_t to) {     \
      netloft::subtract_rows<Register>(f, begin, end, last, from, to);                                       \
    }                                                                                                        \
    __VA_ARGS__ static void solve_upper(const FrontPanels& f, const std::int32_t* exchanged,                 \
                                        std::ptrdiff_t from, std::ptrdiff_t to) {                            \
      netloft::solve_upper<Register>(f, exchanged, from, to);                                                \
    }                                                                                                        \
    __VA_ARGS__ static void update_columns(const FrontPanels& f, double* C, std::ptrdiff_t from,             \
                                           std::ptrdiff_t to) {                                              \
      netloft::update<Register>(f, C, from, to);                                                             \
    }                                                                                                        \
    static constexpr FrontKernels all{                                                                       \
        eliminate,       update,     forward,       backward,    forward_transposed, backward_transposed,    \
        eliminate_block, solve_rows, subtract_rows, solve_upper, update_columns};                            \
  };

NETLOFT_KERNELS(Plain, Two, )
NETLOFT_KERNELS(Avx2, Four, NETLOFT_AVX2)
NETLOFT_KERNELS(Avx512, Eight, NETLOFT_AVX512)

}  // namespace

std::vector<FrontKernels> front_kernels_here() {
  return wide::those_here(Plain::all, Avx2::all, Avx512::all);
}

const FrontKernels& front_kernels() {
  static const FrontKernels best = front_kernels_here().back();
  return best;
}

}  // namespace netloft
