// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>

#include "solvers/newton/direction.hpp"
#include "solvers/newton/iterate.hpp"
#include "solvers/newton/newton.hpp"

namespace netloft::newton {

/// What became of a direction.
struct Step {
  enum class Rule { none, energy, residual };
  Rule rule = Rule::none;  // by which u has moved
  double length = 0;       // t of (4)
  explicit operator bool() const { return rule != Rule::none; }
};

/// How far to go along a direction.
class Globalisation {
 public:
  explicit Globalisation(const Newton::Parameters& parameters) : p_(parameters) {}

  /// Moves u along s, as (4) and (5) want it or, at round-off, if that does not raise the residual.
  Step take(Iterate& iterate, const Direction& direction);

 private:
  Step take_by_energy(Iterate& iterate, const Direction& direction);
  std::optional<Sample> try_whole_step(Iterate& iterate, std::span<const double> s) const;

  const Newton::Parameters& p_;
  bool last_went_uphill_ = false;
};

}  // namespace netloft::newton
