// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::hard_cases {

namespace {

constexpr std::size_t kNodesKept = 16;
constexpr double kMoreDigits = 0.1;

double distance_from(const Reference& reference, const std::vector<double>& x) {
  double largest = 0;
  for (const auto& known : reference.nodes) {
    if (3 * std::size_t{known.node} + 2 >= x.size()) return std::numeric_limits<double>::infinity();
    const double* at = &x[3 * std::size_t{known.node}];
    largest = std::max(largest, std::hypot(at[0] - known.x[0], at[1] - known.x[1], at[2] - known.x[2]));
  }
  return largest / reference.size;
}

/// Diagonal of the bounding box of all nodes; 1 if there are none.
double diagonal(const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (std::size_t d = axis; d < x.size(); d += 3) lo = std::min(lo, x[d]), hi = std::max(hi, x[d]);
    if (hi > lo) sum += (hi - lo) * (hi - lo);
  }
  return sum > 0 ? std::sqrt(sum) : 1;
}

Where judge_failure(const Ended& ended, Expected expected, bool has_reference) {
  if (expected == Expected::none) return ended.out_of_budget ? Where::late : Where::honest;
  if (!has_reference && flutters(ended.solution)) return Where::flutters;
  if (!has_reference && ended.solution.does_not_settle && !ended.out_of_budget) return Where::unsettled;
  return ended.solution.status == SolveStatus::unstable ? Where::unstable : Where::failed;
}

/// A result within kSameShape is at the reference. A unique answer must even be within kSamePlace: beyond it,
/// as after a solve to a coarse tolerance, it is only `near`.
Where judge_precision(const Verdict& v, Expected expected) {
  return expected == Expected::unique && v.distance > kSamePlace ? Where::near : Where::reference;
}

Where judge_place(const HardCase& c, const Verdict& v, bool conservative) {
  const bool same_energy = !conservative || std::abs(v.gap) <= kSameEnergy;
  if (same_energy && c.neutral) return Where::reference;
  if (same_energy && v.distance <= kSameShape) return judge_precision(v, c.expected);
  if (conservative && v.gap < -kSameEnergy) return Where::lower;
  if (c.expected == Expected::unique) return Where::wrong;
  return same_energy ? Where::another : Where::higher;
}

}  // namespace

double energy_noise(const Reference& r, const Solution& s) {
  const double rounding = std::max(r.noise, s.balance.floor * r.size);
  return std::max({kSameEnergy * std::abs(r.energy), kSameEnergy * r.load * r.size, rounding,
                   std::numeric_limits<double>::min()});
}

Verdict judge(const HardCase& c, const std::optional<Reference>& reference, const Ended& ended) {
  Verdict v;
  const Solution& s = ended.solution;
  if (reference && !ended.positions.empty()) {
    v.distance = distance_from(*reference, ended.positions);
    v.gap = (s.energy - reference->energy) * kSameEnergy / energy_noise(*reference, s);
  }
  if (ended.unfit)
    v.where = Where::unfit;
  else if (!ended.claims_success())
    v.where = judge_failure(ended, c.expected, reference.has_value());
  else if (c.expected == Expected::none)
    v.where = Where::lied;
  else if (ended.stability == Stability::unstable)
    v.where = Where::wrong;
  else if (!ended.is_at_rest())
    v.where = Where::unproven;
  else
    v.where = reference ? judge_place(c, v, ended.conservative) : Where::another;
  return v;
}

bool is_answer(Where where) {
  return where == Where::reference || where == Where::lower || where == Where::another;
}
bool is_honest(Where where) {
  return where == Where::honest || where == Where::flutters || where == Where::unsettled;
}
bool is_right(Where where) { return is_answer(where) || is_honest(where); }
bool is_claimed_wrong(Where where) { return where == Where::wrong || where == Where::lied; }

const char* name_of(Where where) {
  switch (where) {
    case Where::reference:
      return "reference";
    case Where::near:
      return "near";
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
    case Where::flutters:
      return "flutters";
    case Where::unsettled:
      return "unsettled";
    case Where::unproven:
      return "unproven";
    case Where::late:
      return "late";
    case Where::lied:
      return "lied";
    case Where::unfit:
      return "unfit";
    case Where::not_run:
      return "not run";
    default:
      return "failed";
  }
}

bool is_closer(const Ended& ended, const Reference& reference) {
  return distance_from(reference, ended.positions) <= kSameShape &&
         ended.solution.balance.residual < kMoreDigits * reference.residual;
}

Reference make_reference(const Ended& ended, std::string found_by) {
  const std::vector<double>& x = ended.positions;
  const Balance& b = ended.solution.balance;
  Reference r{ended.unknowns, ended.solution.energy, diagonal(x), b.scale, 0, {}, std::move(found_by),
              b.residual};
  r.noise = b.floor * r.size;
  const std::size_t nodes = x.size() / 3, step = std::max<std::size_t>(1, nodes / kNodesKept);
  for (std::size_t n = step / 2; n < nodes; n += step)
    r.nodes.push_back({static_cast<std::uint32_t>(n), {x[3 * n], x[3 * n + 1], x[3 * n + 2]}});
  return r;
}

}  // namespace netloft::hard_cases
