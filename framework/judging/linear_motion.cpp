// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/linear_motion.hpp"

#include "framework/assembler/pattern.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// Time constant τ of (2) in growth.hpp, for unknowns with neither mass nor damping [s]
constexpr double kTimeToFollow = 1e-3;
// Multiple of the linear stiffness that is added to K₊ in the norm (8) of cayley.hpp, for directions without
// any other stiffness. It is the geometric mean of the rounding error of a matrix and the least stiffness
// that matters.
const double kMetricFraction = std::sqrt(kRoundingOfMatrix * kMatters);

bool is_symmetric(const SparsePattern& p, std::span<const double> A) {
  if (p.symmetric) return true;
  double largest = 0, most = 0;
  for_entries(p, A, [&](std::int32_t r, std::int32_t c, double value) {
    largest = std::max(largest, std::abs(value));
    if (r > c) most = std::max(most, std::abs(value - A[find_slot(p, c, r)]));
  });
  return most <= kRoundingOfMatrix * largest;
}

/// Whether ½ (A + Aᵀ) has positive eigenvalues only. The pattern of A is symmetric.
bool is_symmetric_part_positive(const SparsePattern& p, std::span<const double> A,
                                const MakeFactorisation& make, Statistics& cost) {
  SparsePattern lower;
  lower.size = p.size;
  lower.node = p.node;
  lower.column_start = {0};
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
  ++cost.factorisations;
  return factorisation->factorise(values).status == FactorStatus::ok;
}

std::vector<double> largest_by_column(const SparsePattern& p, std::span<const double> A) {
  std::vector<double> largest(static_cast<std::size_t>(p.size));
  for_entries(p, A, [&](std::int32_t, std::int32_t c, double value) {
    double& most = largest[static_cast<std::size_t>(c)];
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  });
  return largest;
}

/// For each unknown, how strongly C drives a motion instead of damping it, at least zero: the largest of
/// minus its diagonal entry and, for every other entry of its column, the excess of this entry over the
/// geometric mean of both diagonal entries.
std::vector<double> driving_part(const SparsePattern& p, std::span<const double> C) {
  std::vector<double> drives(static_cast<std::size_t>(p.size));
  const auto damped = [&](std::int32_t i) { return std::max(0.0, C[find_slot(p, i, i)]); };
  for_entries(p, C, [&](std::int32_t r, std::int32_t c, double value) {
    const double mirrored = p.symmetric ? value : C[find_slot(p, c, r)];
    const double excess = 0.5 * std::abs(value + mirrored) - std::sqrt(damped(r) * damped(c));
    if (std::isfinite(excess))
      drives[static_cast<std::size_t>(c)] = std::max(drives[static_cast<std::size_t>(c)], excess);
  });
  return drives;
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

/// Change of K over the remaining Newton step (LinearMotion::K_error); empty if the step is not known, or
/// elements are undefined at its end.
std::vector<double> change_of_stiffness(Assembler& assembler, const RestPlace& at,
                                        const std::vector<double>& K) {
  if (at.after.empty()) return {};
  const std::vector<double> x = between(at.x, at.after, at.fraction),
                            low = between(at.x_low, at.after_low, at.fraction);
  std::vector<double> change(assembler.value_slots());
  const Kinematics motion{.cu = 1, .x_low = low.empty() ? nullptr : low.data()};
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
  const auto n = largest_by_column(p, N), K = largest_by_column(p, m.K), C = largest_by_column(p, m.C),
             drives = driving_part(p, m.C);
  double fastest = 0;
  for (std::int32_t i = 0; i < p.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double mass = fraction * m.M[find_slot(p, i, i)];
    const double alone = mass > 0    ? drives[at] / mass + std::sqrt(n[at] / mass)
                         : C[at] > 0 ? K[at] / C[at]
                                     : 0;
    fastest = std::max(fastest, alone);
  }
  return fastest;
}

bool is_stable_by_energy(const SparsePattern& p, const LinearMotion& m, const MakeFactorisation& make,
                         Statistics& cost) {
  const auto is_positive = [&](std::span<const double> A) {
    std::vector<double> sum(p.value_slots());
    double largest = 0, largest_of_convex = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      largest = std::max(largest, std::abs(A[i]));
      largest_of_convex = std::max(largest_of_convex, std::abs(m.convex[i]));
    }
    if (largest == 0) return true;
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] = A[i] + kRoundingOfMatrix * largest / largest_of_convex * m.convex[i];
    return is_symmetric_part_positive(p, sum, make, cost);
  };
  return is_symmetric(p, m.K) && is_symmetric(p, m.M) && is_positive(m.M) && is_positive(m.C) &&
         is_symmetric_part_positive(p, m.K, make, cost);
}

bool linearise(Assembler& assembler, const RestPlace& at, LinearMotion& m) {
  const std::size_t slots = assembler.value_slots();  // there are more slots than entries of the pattern
  std::vector<double> metric(slots);
  for (auto* A : {&m.K, &m.C, &m.M, &m.convex}) A->assign(slots, 0.0);
  const double* low = at.x_low.empty() ? nullptr : at.x_low.data();
  const auto evaluate = [&](std::vector<double>& A, MatrixKind kind, double cu, double cv, double ca) {
    const Kinematics motion{.cu = cu, .cv = cv, .ca = ca, .x_low = low};
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
  m.K_error = change_of_stiffness(assembler, at, m.K);
  return true;
}

}  // namespace netloft
