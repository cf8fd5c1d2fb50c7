// SPDX-License-Identifier: BSD-3-Clause
#include "io/stability/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::io {

namespace {

constexpr std::size_t kNodesKept = 16;

double distance_from(const Reference& reference, const std::vector<double>& x) {
  double largest = 0;
  for (const auto& known : reference.nodes) {
    if (3 * std::size_t{known.node} + 2 >= x.size()) return std::numeric_limits<double>::infinity();
    const double* at = &x[3 * std::size_t{known.node}];
    largest = std::max(largest, std::hypot(at[0] - known.x[0], at[1] - known.x[1], at[2] - known.x[2]));
  }
  return largest / reference.size;
}

/// Energies are a part of this: their own amount, or the work of the largest load across the gear [J].
double energy_scale(const Reference& reference) {
  return std::max(
      {std::abs(reference.energy), reference.load * reference.size, std::numeric_limits<double>::min()});
}

bool claims_success(const Solution& s) { return s.status == SolveStatus::converged; }

Where judge_failure(const Ended& ended, Expected expected) {
  if (expected == Expected::none) return ended.out_of_time ? Where::late : Where::honest;
  return ended.solution.status == SolveStatus::unstable ? Where::unstable : Where::failed;
}

Where judge_place(const StabilityCase& c, const Verdict& v, bool conservative) {
  const bool same_energy = std::abs(v.gap) <= kSameEnergy;
  const bool same_place = v.distance <= kSamePlace;
  if (!conservative)
    return same_place ? Where::reference : c.expected == Expected::unique ? Where::wrong : Where::another;
  if (same_energy && (same_place || c.neutral)) return Where::reference;
  if (v.gap < -kSameEnergy) return Where::lower;
  if (c.expected == Expected::unique) return Where::wrong;
  return same_energy ? Where::another : Where::higher;
}

}  // namespace

Verdict judge(const StabilityCase& c, const std::optional<Reference>& reference, const Ended& ended) {
  Verdict v;
  const Solution& s = ended.solution;
  if (reference && !s.x.empty()) {
    v.distance = distance_from(*reference, s.x);
    v.gap = (s.energy - reference->energy) / energy_scale(*reference);
  }
  if (!claims_success(s))
    v.where = judge_failure(ended, c.expected);
  else if (c.expected == Expected::none)
    v.where = Where::lied;
  else if (s.stability == Stability::unstable)
    v.where = Where::wrong;
  else
    v.where = reference ? judge_place(c, v, ended.conservative) : Where::another;
  return v;
}

bool is_arrival(Where where) {
  return where == Where::reference || where == Where::lower || where == Where::another;
}
bool is_right(Where where) { return is_arrival(where) || where == Where::honest; }
bool is_lie(Where where) { return where == Where::wrong || where == Where::lied; }

const char* name_of(Where where) {
  switch (where) {
    case Where::reference:
      return "reference";
    case Where::lower:
      return "lower";
    case Where::another:
      return "another";
    case Where::higher:
      return "higher";
    case Where::wrong:
      return "wrong";
    case Where::unstable:
      return "unstable";
    case Where::honest:
      return "honest";
    case Where::late:
      return "late";
    case Where::lied:
      return "lied";
    case Where::not_run:
      return "not run";
    default:
      return "failed";
  }
}

Reference make_reference(const Solution& s, std::size_t unknowns, std::string found_by) {
  Reference r{unknowns, s.energy, 1, s.balance.scale, {}, std::move(found_by)};
  const std::size_t nodes = s.x.size() / 3, step = std::max<std::size_t>(1, nodes / kNodesKept);
  std::array<double, 3> lo{}, hi{};
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t i = 0; i < 3; ++i) {
      const double v = s.x[3 * n + i];
      lo[i] = n ? std::min(lo[i], v) : v, hi[i] = n ? std::max(hi[i], v) : v;
    }
  const double diagonal = std::hypot(hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]);
  if (diagonal > 0) r.size = diagonal;
  for (std::size_t n = step / 2; n < nodes; n += step)
    r.nodes.push_back({static_cast<std::uint32_t>(n), {s.x[3 * n], s.x[3 * n + 1], s.x[3 * n + 2]}});
  return r;
}

}  // namespace netloft::io
