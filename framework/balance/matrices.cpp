// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/matrices.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

/// Calls visit(row, column, value) for every entry of the whole matrix.
template <class Visit>
void for_matrix(const SparsePattern& p, std::span<const double> values, Visit&& visit) {
  for (std::size_t c = 0; c < static_cast<std::size_t>(p.size); ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      const double a = values[p.slot_of(k)];
      visit(r, c, a);
      if (p.symmetric && r != c) visit(c, r, a);
    }
}

}  // namespace

Matrices::Matrices(Assembler& assembler, Statistics& statistics)
    : assembler_(assembler), statistics_(statistics) {
  for (auto* matrix : {&exact_, &convex_, &metric_, &sum_}) matrix->reserve(assembler.value_slots());
  diagonal_.reserve(static_cast<std::size_t>(assembler.pattern().size));
}

std::vector<double>& Matrices::slots(MatrixKind kind) {
  auto& v = kind == MatrixKind::exact ? exact_ : kind == MatrixKind::convex ? convex_ : metric_;
  v.resize(assembler_.value_slots());
  return v;
}

void Matrices::need_metric() {
  if (!metric_.empty()) return;
  Timed timed(statistics_.assembly_seconds);
  if (!assembler_.evaluate(assembler_.start(),
                           {.matrix = MatrixKind::metric, .values = slots(MatrixKind::metric).data()}))
    metric_.assign(assembler_.value_slots(), 0.0);
  const SparsePattern& pattern = assembler_.pattern();
  for (std::int32_t i = 0; i < pattern.size; ++i) diagonal_.push_back(metric_[find_slot(pattern, i, i)]);
}

std::span<const double> Matrices::shifted(int matrix, double shift) {
  const std::size_t entries = assembler_.pattern().value_slots();
  const std::vector<double>* base = matrix == NETLOFT_EXACT    ? &exact_
                                    : matrix == NETLOFT_CONVEX ? &convex_
                                                               : nullptr;
  if (base && base->empty()) return {};
  if (shift == 0 && base) return {base->data(), entries};
  need_metric();
  sum_.resize(entries);
  for (std::size_t i = 0; i < entries; ++i) sum_[i] = (base ? (*base)[i] : 0.0) + shift * metric_[i];  // (1)
  return sum_;
}

std::span<const double> Matrices::between(double blend, double shift) {
  if (exact_.empty() || convex_.empty()) return {};
  need_metric();
  const std::size_t entries = assembler_.pattern().value_slots();
  sum_.resize(entries);
  for (std::size_t i = 0; i < entries; ++i)
    sum_[i] = exact_[i] + blend * (convex_[i] - exact_[i]) + shift * metric_[i];  // (2)
  return sum_;
}

bool Matrices::multiply(int matrix, double shift, const double* x, double* y) {
  const SparsePattern& pattern = assembler_.pattern();
  const auto v = shifted(matrix, shift);
  if (v.empty() && pattern.size > 0) return false;
  std::fill_n(y, pattern.size, 0.0);
  for_matrix(pattern, v, [&](std::size_t r, std::size_t c, double a) { y[r] += a * x[c]; });
  return true;
}

bool Matrices::multiply_transposed(int matrix, const double* x, double* y) {
  const SparsePattern& pattern = assembler_.pattern();
  const auto v = shifted(matrix, 0);
  if (v.empty() && pattern.size > 0) return false;
  std::fill_n(y, pattern.size, 0.0);
  for_matrix(pattern, v, [&](std::size_t r, std::size_t c, double a) { y[c] += a * x[r]; });
  return true;
}

bool Matrices::row_sums(int matrix, double shift, double* y) {
  const SparsePattern& pattern = assembler_.pattern();
  const auto v = shifted(matrix, shift);
  if (v.empty() && pattern.size > 0) return false;
  std::fill_n(y, pattern.size, 0.0);
  for_matrix(pattern, v, [&](std::size_t r, std::size_t, double a) { y[r] += std::abs(a); });
  return true;
}

}  // namespace netloft
