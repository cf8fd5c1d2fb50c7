// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/linear_motion.hpp"

#include "framework/assembler/pattern.hpp"

#include <netloft/imbalance.hpp>
#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// Time constant τ [s] of (2) in growth.hpp, for unknowns without mass and damping.
constexpr double kTimeToFollow = 1e-3;
// This multiple of the linear stiffness is added to K₊ in the norm (8) of cayley.hpp, for directions that
// have no other stiffness. The multiple is the geometric mean of the rounding error of a matrix and the least
// stiffness that matters.
const double kMetricFraction = std::sqrt(kRoundingOfMatrix * kMatters);

/// Calls visit(row, column, slot, mirrored slot) for every entry on and below the diagonal, column by column,
/// while visit returns true. The pattern must be symmetric, as all patterns of scenes are.
template <class Visit>
bool for_pairs(const SparsePattern& p, Visit&& visit) {
  // For each column, the entry above the diagonal that is visited next.
  std::vector<std::int32_t> next(p.column_start.begin(), p.column_start.end());
  for (std::int32_t c = 0; c < p.size; ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k) {
      const std::int32_t r = p.row[k];
      if (r < c) continue;
      const std::size_t mirrored =
          p.symmetric ? k : static_cast<std::size_t>(next[static_cast<std::size_t>(r)]++);
      if (!visit(r, c, p.slot_of(k), p.slot_of(mirrored))) return false;
    }
  return true;
}

bool is_symmetric(const SparsePattern& p, std::span<const double> A) {
  const double most = kRoundingOfMatrix * largest_of(A);
  return p.symmetric || for_pairs(p, [&](std::int32_t, std::int32_t, std::size_t at, std::size_t mirrored) {
           return std::abs(A[at] - A[mirrored]) <= most;
         });
}

/// Whether ½ (A + Aᵀ) has positive eigenvalues only.
bool is_symmetric_part_positive(const SparsePattern& p, std::span<const double> A, Factors& factors) {
  SparsePattern lower;
  lower.size = p.size;
  lower.node = p.node;
  lower.column_start.assign(static_cast<std::size_t>(p.size) + 1, 0);
  std::vector<double> values;
  for_pairs(p, [&](std::int32_t r, std::int32_t c, std::size_t at, std::size_t mirrored) {
    lower.row.push_back(r);
    values.push_back(0.5 * (A[at] + A[mirrored]));
    lower.column_start[static_cast<std::size_t>(c) + 1] = static_cast<std::int32_t>(lower.row.size());
    return true;
  });
  const auto factorisation = factors.make()(MatrixClass::positive_definite);
  factorisation->analyse(lower);
  ++factors.statistics().factorisations;
  return factorisation->factorise(values).status == FactorStatus::ok;
}

std::vector<double> largest_by_column(const SparsePattern& p, std::span<const double> A) {
  std::vector<double> largest(static_cast<std::size_t>(p.size));
  const auto keep = [&](std::int32_t, std::int32_t c, double value) {
    double& most = largest[static_cast<std::size_t>(c)];
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  };
  for_entries(p, keep, A);
  return largest;
}

std::vector<double> diagonal_of(const SparsePattern& p, std::span<const double> A) {
  std::vector<double> diagonal(static_cast<std::size_t>(p.size));
  for (std::int32_t i = 0; i < p.size; ++i) diagonal[static_cast<std::size_t>(i)] = A[find_slot(p, i, i)];
  return diagonal;
}

/// The mass that a pair of unknowns gives to the second of them: its own, or that of the first if it has
/// none.
double mass_beside(std::span<const double> mass, std::size_t at, std::size_t beside) {
  return mass[beside] > 0 ? mass[beside] : mass[at];
}

/// For each unknown with mass, the rate (6e) at which C damps it [1/s]; negative if C drives it.
std::vector<double> damping_rates(const SparsePattern& p, std::span<const double> C,
                                  std::span<const double> mass) {
  const std::vector<double> damping = diagonal_of(p, C);
  std::vector<double> rates(static_cast<std::size_t>(p.size));
  for (std::size_t i = 0; i < rates.size(); ++i)
    if (mass[i] > 0) rates[i] = damping[i] / mass[i];
  const auto keep = [&](std::int32_t i, std::int32_t other, double between) {
    const auto at = static_cast<std::size_t>(i), beside = static_cast<std::size_t>(other);
    if (!(mass[at] > 0)) return;
    const double m = mass_beside(mass, at, beside);
    const double a = damping[at] / mass[at], b = between / std::sqrt(mass[at] * m), d = damping[beside] / m;
    const double rate = 0.5 * (a + d) - std::hypot(0.5 * (a - d), b);  // (6e)
    if (rate < 0 || p.node[at] == p.node[beside]) rates[at] = std::min(rates[at], rate);
  };
  for_pairs(p, [&](std::int32_t r, std::int32_t c, std::size_t at, std::size_t mirrored) {
    const double between = 0.5 * (C[at] + C[mirrored]);  // (6e)
    if (r != c) keep(r, c, between), keep(c, r, between);
    return true;
  });
  return rates;
}

/// For each unknown with mass, the sum (6d) for A.
std::vector<double> row_sums(const SparsePattern& p, std::span<const double> A,
                             std::span<const double> mass) {
  std::vector<double> sums(static_cast<std::size_t>(p.size));
  const auto add = [&](std::int32_t i, std::int32_t other, double between) {
    const auto at = static_cast<std::size_t>(i), beside = static_cast<std::size_t>(other);
    if (mass[at] > 0) sums[at] += between / std::sqrt(mass[at] * mass_beside(mass, at, beside));
  };
  for_pairs(p, [&](std::int32_t r, std::int32_t c, std::size_t at, std::size_t mirrored) {
    const double between = 0.5 * (std::abs(A[at]) + std::abs(A[mirrored]));  // (6d)
    add(r, c, between);
    if (r != c) add(c, r, between);
    return true;
  });
  return sums;
}

/// Adds the damping (2) of growth.hpp, C = τ G, for unknowns with neither mass nor damping.
void add_damping_of_massless(const SparsePattern& p, std::span<const double> metric, LinearMotion& m) {
  std::vector<bool> follows(static_cast<std::size_t>(p.size), true);
  const auto each = [&](auto&& visit) {
    for (std::int32_t c = 0; c < p.size; ++c)
      for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
           k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k)
        visit(static_cast<std::size_t>(p.row[k]), static_cast<std::size_t>(c), p.slot_of(k));
  };
  each([&](std::size_t r, std::size_t c, std::size_t at) {
    if (m.M[at] != 0 || m.C[at] != 0) follows[r] = follows[c] = false;
  });
  each([&](std::size_t r, std::size_t c, std::size_t at) {
    if (follows[r] && follows[c]) m.C[at] += kTimeToFollow * metric[at];
  });
}

/// Returns a + t (b − a); an empty vector counts as zeros.
std::vector<double> between(std::span<const double> a, std::span<const double> b, double t) {
  std::vector<double> there(a.begin(), a.end());
  there.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < there.size(); ++i) there[i] += t * ((b.empty() ? 0 : b[i]) - there[i]);
  return there;
}

/// Change of K over the remaining Newton step (LinearMotion::K_error); empty if the step is not known or
/// forces are undefined at the end of the step.
std::vector<double> change_of_stiffness(Assembler& assembler, const RestPlace& at,
                                        const std::vector<double>& K, Statistics& cost) {
  if (at.after.empty()) return {};
  const std::vector<double> x = between(at.x, at.after, at.fraction),
                            low = between(at.x_low, at.after_low, at.fraction);
  std::vector<double> change(assembler.value_slots());
  const Kinematics motion{.cu = 1, .x_low = low.empty() ? nullptr : low.data()};
  ++cost.matrices;
  if (!assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = change.data(), .motion = motion}))
    return {};
  change.resize(K.size());
  for (std::size_t i = 0; i < K.size(); ++i) change[i] -= K[i];
  return change;
}

}  // namespace

double fastest_growth(const SparsePattern& p, const LinearMotion& m, double fraction) {
  std::vector<double> N(m.K);
  for (std::size_t i = 0; i < N.size(); ++i) N[i] -= m.convex[i];
  const std::vector<double> ones(static_cast<std::size_t>(p.size), 1.0);
  const auto mass = diagonal_of(p, m.M), n = row_sums(p, N, mass), d = damping_rates(p, m.C, mass),
             K = row_sums(p, m.K, ones), C = largest_by_column(p, m.C);
  double fastest = 0;
  for (std::size_t at = 0; at < mass.size(); ++at) {
    const double root = std::sqrt(d[at] * d[at] + 4 * fraction * n[at]);
    const double rate = !(mass[at] > 0) ? (C[at] > 0 ? K[at] / C[at] : 0)
                        : d[at] > 0     ? 2 * n[at] / (d[at] + root)  // without cancellation
                                        : (root - d[at]) / (2 * fraction);
    if (std::isfinite(rate)) fastest = std::max(fastest, rate);
  }
  return fastest;
}

bool is_stable_by_energy(const SparsePattern& p, const LinearMotion& m, Factors& factors) {
  const auto is_positive = [&](std::span<const double> A) {
    const double largest = largest_of(A);
    if (largest == 0) return true;
    const double weight = kRoundingOfMatrix * largest / largest_of(m.convex);
    std::vector<double> sum(A.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = A[i] + weight * m.convex[i];
    return is_symmetric_part_positive(p, sum, factors);
  };
  return is_symmetric(p, m.K) && is_symmetric(p, m.M) && is_positive(m.M) && is_positive(m.C) &&
         is_symmetric_part_positive(p, m.K, factors);
}

bool linearise(Assembler& assembler, const RestPlace& at, Statistics& cost, LinearMotion& m) {
  const std::size_t slots = assembler.value_slots();  // the array has more slots than the pattern has entries
  std::vector<double> metric(slots);
  for (auto* A : {&m.K, &m.C, &m.M, &m.convex}) A->assign(slots, 0.0);
  const double* low = at.x_low.empty() ? nullptr : at.x_low.data();
  const auto evaluate = [&](std::vector<double>& A, MatrixKind kind, double cu, double cv, double ca) {
    const Kinematics motion{.cu = cu, .cv = cv, .ca = ca, .x_low = low};
    ++cost.matrices;
    return assembler.evaluate(at.x, {.matrix = kind, .values = A.data(), .motion = motion});
  };
  if (!evaluate(m.K, MatrixKind::exact, 1, 0, 0) || !evaluate(m.C, MatrixKind::exact, 0, 1, 0) ||
      !evaluate(m.M, MatrixKind::exact, 0, 0, 1) || !evaluate(m.convex, MatrixKind::convex, 1, 0, 0) ||
      !evaluate(metric, MatrixKind::metric, 1, 0, 0))
    return false;
  m.is_damped = std::any_of(m.C.begin(), m.C.end(), [](double c) { return c != 0; });
  add_damping_of_massless(assembler.pattern(), metric, m);
  for (std::size_t i = 0; i < slots; ++i) m.convex[i] += kMetricFraction * metric[i];
  for (auto* A : {&m.K, &m.C, &m.M, &m.convex}) A->resize(assembler.pattern().value_slots());
  m.K_error = [&assembler, &at, &cost, &m] { return change_of_stiffness(assembler, at, m.K, cost); };
  return true;
}

}  // namespace netloft
