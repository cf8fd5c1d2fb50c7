// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"

namespace netloft {

/// Chooses among the equilibria that a strategy answers, by this rule: one that converged before one that is
/// unstable; among those that converged the one of least energy, if every force has an energy; else the
/// first. Two are the same shape where no node is further from itself than 1e-5 of the gear's size, or where
/// what tells them apart moves without any force and their energies are equal.
class EquilibriumChoice {
 public:
  /// `gear_size` [m]; `has_energy`: every force has one.
  EquilibriumChoice(const Scene& scene, const Assembler& assembler, double gear_size, bool has_energy);

  void add(Solution solution);
  bool has_any() const { return !found_.empty(); }
  /// With what the others are. There must be one.
  Solution best() const;

 private:
  struct Found {
    Solution solution;
    int times = 1;
  };

  bool is_same(const Solution& a, const Solution& b) const;
  bool is_better(const Solution& a, const Solution& b) const;
  double energy_noise(const Solution& a, const Solution& b) const;

  const Scene& scene_;
  const Assembler& assembler_;
  double gear_size_;
  bool has_energy_;
  int answers_ = 0;
  std::vector<Found> found_;
};

}  // namespace netloft
