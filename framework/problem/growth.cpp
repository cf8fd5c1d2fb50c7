// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include "framework/assembler/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft {

namespace {

constexpr int kDecades = 9, kPowers = 60, kMeasured = 20;

/// y = A x, of a matrix that may be stored as its lower triangle.
void multiply(const SparsePattern& p, std::span<const double> values, std::span<const double> x,
              std::vector<double>& y) {
  y.assign(x.size(), 0.0);
  for (std::size_t c = 0; c < x.size(); ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      y[r] += values[p.slot_of(k)] * x[c];
      if (p.symmetric && r != c) y[c] += values[p.slot_of(k)] * x[r];
    }
}

double norm(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a * a;
  return std::sqrt(sum);
}

/// A vector with a share in every direction, the same on every machine: fractions of multiples of the golden
/// ratio.
std::vector<double> scattered(std::size_t size) {
  constexpr double kGolden = 0.61803398874989485;
  std::vector<double> v(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double multiple = kGolden * static_cast<double>(i + 1);
    v[i] = 2 * (multiple - std::floor(multiple)) - 1;
  }
  return v;
}

/// Whether ½ (A + Aᵀ) has positive eigenvalues only. The pattern of A is symmetric.
bool is_symmetric_part_positive(const SparsePattern& p, std::span<const double> A,
                                const MakeFactorisation& make) {
  SparsePattern lower;
  lower.size = p.size, lower.node = p.node, lower.column_start = {0};
  std::vector<double> values;
  for (std::int32_t c = 0; c < p.size; ++c) {
    const auto end = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]);
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]); k < end; ++k) {
      const std::int32_t r = p.row[k];
      if (r < c) continue;
      lower.row.push_back(r);
      values.push_back(p.symmetric ? A[p.slot_of(k)] : 0.5 * (A[p.slot_of(k)] + A[find_slot(p, c, r)]));
    }
    lower.column_start.push_back(static_cast<std::int32_t>(lower.row.size()));
  }
  const auto factorisation = make(MatrixClass::positive_definite);
  factorisation->analyse(lower);
  return factorisation->factorise(values).status == FactorStatus::ok;
}

/// Growth of a scattered vector under powers of (2), averaged over the last of them.
double growth_at(double sigma, const SparsePattern& p, std::span<const double> K, std::span<const double> M,
                 Factorisation& factorisation) {
  std::vector<double> plus(K.size()), minus(K.size());
  for (std::size_t i = 0; i < K.size(); ++i) plus[i] = K[i] + sigma * M[i], minus[i] = sigma * M[i] - K[i];
  if (factorisation.factorise(plus).status != FactorStatus::ok)
    return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> y = scattered(static_cast<std::size_t>(p.size)), z;
  double logarithm = 0;
  for (int k = 0; k < kPowers; ++k) {
    const double before = norm(y);
    multiply(p, minus, y, z);
    factorisation.solve(z, y);
    const double after = norm(y);
    if (!(after > 0) || !std::isfinite(after)) return after > 0 ? std::numeric_limits<double>::infinity() : 0;
    if (k >= kPowers - kMeasured) logarithm += std::log(after / before);
    for (double& v : y) v /= after;
  }
  return std::exp(logarithm / kMeasured);
}

}  // namespace

double largest_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make) {
  std::vector<double> K(assembler.value_slots()), M(assembler.value_slots());
  if (!assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = K.data()}) ||
      !assembler.evaluate(x, {.matrix = MatrixKind::metric, .values = M.data()}))
    return std::numeric_limits<double>::quiet_NaN();
  const SparsePattern& pattern = assembler.pattern();
  if (is_symmetric_part_positive(pattern, K, make)) return 0;  // (3)
  const auto factorisation = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  double largest = 0, sigma = 1;
  for (int decade = 0; decade < kDecades; ++decade, sigma /= 10) {
    const double growth = growth_at(sigma, pattern, K, M, *factorisation);
    if (std::isnan(growth)) return growth;
    largest = std::max(largest, growth);
  }
  return largest;
}

}  // namespace netloft
