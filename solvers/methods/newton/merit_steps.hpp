// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "solvers/methods/newton/direction.hpp"
#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/newton.hpp"
#include "solvers/methods/newton/step.hpp"

namespace netloft::newton {

/// a of (8): how a path along s has to bend so that stiff members keep their length to second order.
class CurvedStep {
 public:
  /// Memory for `size` unknowns is reserved, and touched by the first search.
  explicit CurvedStep(std::size_t size) {
    minus_second_derivative_.reserve(size);
    a_.reserve(size);
  }
  /// By differences of r over ± t s, with the last factor. Empty where elements are not defined at one of
  /// these points.
  std::span<const double> find(Iterate& iterate, std::span<const double> s, double t);

 private:
  std::vector<double> minus_second_derivative_, a_;
};

/// Steps that are judged by the merit (3), by the rules (4), (5) and (8) of Newton.
class MeritSteps {
 public:
  MeritSteps(const Newton::Parameters& parameters, std::size_t size) : p_(parameters), curved_(size) {}

  /// Moves u along s by (5), else (4), and where (4) ends short, by (8) if that gains more.
  Step take(Iterate& iterate, const Direction& direction);
  /// What m has fallen by, here or by (6).
  void add_gain(double gain) {
    gained_ += gain;
    most_gained_ = std::max(most_gained_, gained_);
  }

 private:
  std::optional<Sample> try_whole_step(Iterate& iterate, const Path& path) const;

  const Newton::Parameters& p_;
  CurvedStep curved_;
  double gained_ = 0, most_gained_ = 0;  // of m, along the path so far
};

}  // namespace netloft::newton
