// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"

namespace netloft {

/// Chooses among the equilibria that a strategy reports. Converged equilibria take precedence over unstable
/// ones. If all forces have a potential, the converged equilibrium of least energy is chosen, otherwise the
/// first one. Two equilibria count as the same shape if the positions of each node differ by at most 1e-5 of
/// the size of the gear. They also count as the same if both are neutral with equal energies, because the
/// gear can then move from one to the other without any force.
class EquilibriumChoice {
 public:
  /// `gear_size` [m]; `has_energy`: whether all forces have a potential.
  EquilibriumChoice(const Scene& scene, const Assembler& assembler, double gear_size, bool has_energy);

  void add(Solution solution);
  bool has_any() const { return !found_.empty(); }
  /// The chosen equilibrium, with a list of the others. Requires that one has been added.
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
