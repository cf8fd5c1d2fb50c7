// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include "framework/assembler/pattern.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <utility>

namespace netloft {

namespace {

// Of (3); and by how much another is tried where −σ is an eigenvalue.
constexpr double kLeastSigma = 1e-10, kMostSigma = 1e16, kAside = 1.3;
constexpr int kPowers = 60, kMeasured = 20;
// ε of (2), by which flow damps where it does not; what is equal but for rounding, of the largest entry.
constexpr double kLittle = 0.01, kRounding = 1e-9;
// Steps that tell the largest eigenvalue; no more where what is new is below this share.
constexpr int kArnoldi = 20;
constexpr double kOneDirection = 1e-9;
// Growth that still falls by this from one measure to the next may be passing: so often it is measured again.
constexpr double kFalls = 1e-3;
constexpr int kMeasures = 16;

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

double dot(std::span<const double> v, std::span<const double> w) {
  return std::inner_product(v.begin(), v.end(), w.begin(), 0.0);
}

double norm(std::span<const double> v) { return std::sqrt(dot(v, v)); }

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

/// Calls visit(row, column, place of the value) for every entry.
template <class Visit>
void for_entries(const SparsePattern& p, Visit&& visit) {
  for (std::int32_t c = 0; c < p.size; ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k)
      visit(p.row[k], c, p.slot_of(k));
}

double trace(const SparsePattern& p, std::span<const double> A) {
  double sum = 0;
  for_entries(p, [&](std::int32_t r, std::int32_t c, std::size_t at) { sum += r == c ? A[at] : 0; });
  return sum;
}

bool is_symmetric(const SparsePattern& p, std::span<const double> A) {
  if (p.symmetric) return true;
  double largest = 0, apart = 0;
  for_entries(p, [&](std::int32_t r, std::int32_t c, std::size_t at) {
    largest = std::max(largest, std::abs(A[at]));
    if (r > c) apart = std::max(apart, std::abs(A[at] - A[find_slot(p, c, r)]));
  });
  return apart <= kRounding * largest;
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

/// A scattered vector under powers of (3).
class Powers {
 public:
  Powers(const SparsePattern& p, std::span<const double> sigma_M_minus_K, Factorisation& plus)
      : p_(p), minus_(sigma_M_minus_K), plus_(plus), y_(scattered(static_cast<std::size_t>(p.size))) {}

  /// Growth per power, averaged over so many.
  double grow(int powers) {
    double logarithm = 0;
    for (int k = 0; k < powers; ++k) {
      advance(y_, y_);
      const double length = norm(y_);
      if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
      if (length == 0) return 0;
      logarithm += std::log(length);
      for (double& v : y_) v /= length;
    }
    return std::exp(logarithm / powers);
  }

  /// Of length 1.
  std::vector<double>& vector() { return y_; }

  /// The largest eigenvalue of (3), by a few steps of Arnoldi's from what the powers have left (Y. Saad,
  /// Numerical Methods for Large Eigenvalue Problems, 2011, chapter 6).
  std::complex<double> eigenvalue() {
    Eigen::MatrixXd Q(p_.size, kArnoldi + 1), H = Eigen::MatrixXd::Zero(kArnoldi, kArnoldi);
    Q.col(0) = Eigen::Map<const Eigen::VectorXd>(y_.data(), p_.size);
    int k = 0;
    for (double rest = 1; k < kArnoldi && rest > kOneDirection * std::abs(H(0, 0)); ++k) {
      if (k > 0) H(k, k - 1) = rest;
      advance({Q.col(k).data(), y_.size()}, next_);
      Q.col(k + 1) = Eigen::Map<const Eigen::VectorXd>(next_.data(), p_.size);
      for (int i = 0; i <= k; ++i) {
        H(i, k) = Q.col(i).dot(Q.col(k + 1));
        Q.col(k + 1) -= H(i, k) * Q.col(i);
      }
      rest = Q.col(k + 1).norm();
      Q.col(k + 1) /= rest;
    }
    const Eigen::VectorXcd all = H.topLeftCorner(k, k).eigenvalues();
    return *std::max_element(all.begin(), all.end(),
                             [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); });
  }

 private:
  void advance(std::span<const double> from, std::vector<double>& to) {
    multiply(p_, minus_, from, z_);
    plus_.solve(z_, to);
  }

  const SparsePattern& p_;
  std::span<const double> minus_;
  Factorisation& plus_;
  std::vector<double> y_, z_, next_{y_};
};

/// Growth under powers of (3): over the last of them, or where it settles.
Growth growth_at(double sigma, const SparsePattern& p, std::span<const double> K, std::span<const double> M,
                 Factorisation& factorisation) {
  std::vector<double> plus(K.size()), minus(K.size());
  for (std::size_t i = 0; i < K.size(); ++i) plus[i] = K[i] + sigma * M[i], minus[i] = sigma * M[i] - K[i];
  if (factorisation.factorise(plus).status != FactorStatus::ok)
    return {.per_power = std::numeric_limits<double>::quiet_NaN()};
  Powers powers(p, minus, factorisation);
  powers.grow(kPowers - kMeasured);
  double growth = powers.grow(kMeasured);
  for (int measure = 1; growth > kGrows && measure < kMeasures; ++measure) {
    const double before = std::exchange(growth, powers.grow(kMeasured));
    if (growth > (1 - kFalls) * before) break;
  }
  if (!(growth > kGrows) || !std::isfinite(growth)) return {.per_power = growth};
  const std::complex<double> mu = powers.eigenvalue(), lambda = sigma * (1.0 - mu) / (1.0 + mu);
  return {growth, -lambda.real(), std::abs(lambda.imag()), std::move(powers.vector())};
}

/// A power of ten that no entry of the diagonal of K is above, over that of M, but for rounding; from 1 to
/// kMostSigma. A pressed member that is next to nothing long pushes aside much more stiffly than its linear
/// stiffness.
double largest_sigma(const SparsePattern& p, std::span<const double> K, std::span<const double> M) {
  double largest = 1;
  for_entries(p, [&](std::int32_t r, std::int32_t c, std::size_t at) {
    if (r == c && M[at] > 0 && std::isfinite(K[at])) largest = std::max(largest, std::abs(K[at]) / M[at]);
  });
  return std::min(kMostSigma, std::pow(10, std::ceil(std::log10(largest) - kRounding)));
}

/// Makes the linear stiffness M the matrix of (2). 1/τ; zero where the trace of C is not positive.
double add_damping(const SparsePattern& p, std::span<const double> C, std::span<double> M) {
  if (!(trace(p, C) > 0)) return 0;
  const double share = trace(p, M) / (kLittle * trace(p, C));
  for (std::size_t i = 0; i < p.value_slots(); ++i) M[i] += share * C[i];
  return share;
}

}  // namespace

Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make,
                   std::span<const double> x_low) {
  const double* low = x_low.empty() ? nullptr : x_low.data();
  // An assembler has more values than its pattern.
  std::vector<double> K(assembler.value_slots()), C = K, M = K;
  if (!assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = K.data(), .motion = {.x_low = low}}) ||
      !assembler.evaluate(
          x, {.matrix = MatrixKind::exact, .values = C.data(), .motion = {.cu = 0, .cv = 1, .x_low = low}}) ||
      !assembler.evaluate(x, {.matrix = MatrixKind::metric, .values = M.data()}))
    return {.per_power = std::numeric_limits<double>::quiet_NaN()};
  const SparsePattern& pattern = assembler.pattern();
  const std::size_t entries = pattern.value_slots();
  const double per_second = add_damping(pattern, C, M);
  Growth growth = find_growth(pattern, std::span(K).first(entries), std::span(M).first(entries), make);
  growth.rate *= per_second, growth.frequency *= per_second;
  return growth;
}

Growth find_growth(const SparsePattern& pattern, std::span<const double> K, std::span<const double> M,
                   const MakeFactorisation& make) {
  if (is_symmetric(pattern, M) && is_symmetric_part_positive(pattern, M, make) &&
      is_symmetric_part_positive(pattern, K, make))
    return {};  // (4)
  const auto factorisation = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  Growth most;
  for (double sigma = largest_sigma(pattern, K, M); sigma > kLeastSigma / 2 && !most.grows(); sigma /= 10) {
    Growth growth = growth_at(sigma, pattern, K, M, *factorisation);
    if (std::isnan(growth.per_power)) growth = growth_at(kAside * sigma, pattern, K, M, *factorisation);
    if (std::isnan(growth.per_power)) return growth;
    if (growth.per_power > most.per_power) most = std::move(growth);
  }
  return most;
}

}  // namespace netloft
