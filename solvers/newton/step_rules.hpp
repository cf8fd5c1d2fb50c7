// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "solvers/newton/direction.hpp"
#include "solvers/newton/iterate.hpp"
#include "solvers/newton/newton.hpp"

namespace netloft::newton {

/// What became of a direction.
struct Step {
  enum class Rule { none, energy, residual, slope };
  Rule rule = Rule::none;        // by which u has moved
  double length = 0;             // t, by whichever rule
  bool is_at_round_off = false;  // what the step promises to gain is less than the energy's round-off
  explicit operator bool() const { return rule != Rule::none; }
};

/// a of (8): how a path along s has to bend so that stiff members keep their length to second order.
class CurvedStep {
 public:
  /// Memory for `size` unknowns is reserved, and touched by the first search.
  explicit CurvedStep(std::size_t size) { minus_second_derivative_.reserve(size), a_.reserve(size); }
  /// By differences of r over ± t s, with the last factor. Empty where elements are not defined at one of
  /// these points.
  std::span<const double> find(Iterate& iterate, std::span<const double> s, double t);

 private:
  std::vector<double> minus_second_derivative_, a_;
};

/// Which step along a direction is accepted: the rules (4) to (8) of Newton.
class StepRules {
 public:
  StepRules(const Newton::Parameters& parameters, std::size_t size) : p_(parameters), curved_(size) {}

  /// Moves u along s: by (5), else (4), else (8); at round-off by the residual, else (7).
  Step take(Iterate& iterate, const Direction& direction);
  /// At round-off, once more with Newton's own step s.
  Step take_newton_step(Iterate& iterate, std::span<const double> s);
  /// (7): by the slope, which still has significant digits where the energy has none.
  Step take_by_slope(Iterate& iterate, std::span<const double> s);
  /// (7) may be tried again: u has moved by another rule.
  void reset_stall_count();

 private:
  Step take_at_round_off(Iterate& iterate, const Direction& direction);
  Step take_by_energy(Iterate& iterate, const Direction& direction);
  std::optional<Sample> try_whole_step(Iterate& iterate, const Path& path) const;
  void record_predicted_decrease(double decrease);
  bool has_stalled() const;

  const Newton::Parameters& p_;
  CurvedStep curved_;
  bool last_went_uphill_ = false;
  double least_decrease_ = std::numeric_limits<double>::infinity();  // −r·s of the steps by (7)
  std::int64_t steps_without_halving_ = 0;                           // it, in a row
};

}  // namespace netloft::newton
