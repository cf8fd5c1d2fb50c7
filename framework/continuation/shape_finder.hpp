// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/verdict.hpp"

namespace netloft {

/// Tells the shapes in which a gear was found in equilibrium from one another, and keeps the best: that of
/// the least energy, or where forces have none, the first. Two are one where no node is further from itself
/// than 1e-5 of the gear's size, or where what tells them apart moves without any force.
class ShapeFinder {
 public:
  /// `gear_size` [m]; `energies_tell`: every force has an energy.
  ShapeFinder(const Scene& scene, const Assembler& assembler, double gear_size, bool energies_tell);

  /// The first is where the gear was found. Of those that follow only equilibria that are not unstable count.
  void add(Solution solution);

  /// With what the others are.
  Solution best();

 private:
  struct Found {
    Solution solution;
    int times = 1;
  };

  bool is_same(const Solution& a, const Solution& b) const;
  double energy_noise(const Solution& a, const Solution& b) const;

  const Scene& scene_;
  const Assembler& assembler_;
  double gear_size_;
  bool energies_tell_;
  int looks_ = -1;  // the first is none
  std::vector<Found> found_;
};

}  // namespace netloft
