// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/energy_budget.hpp"

#include <algorithm>
#include <cstdio>

namespace netloft {

/// Whether a motion has energy that nobody gave it. Steps are looked at singly, each for n like it; with Δ
/// over such a step, sums over them, and maxima over time,
///   made = −Σ n Δnumerical                                                                (1)
///   given = K₀ + max(E₀ − E) + Σ_k max(Σ n Δgiven_k)     E stored, k holds, winches, forces  (2)
///   lost: made > ½ given + W, ten looks in a row, or at the last                             (3)
/// W [J] is a work too small to speak of; ten, because a stable scheme may overshoot in its first steps, if
/// they are far longer than the periods it skips, and takes the energy back in those that follow. Of the
/// scenes in gear-library/scenes/dynamics, by all schemes and accuracies, motions whose path is found within
/// 2 % make up to 0.15 of what they are given; those that make ½ all go on to make 0.8 to 3·10⁸ times as
/// much as was given, and lose their path by 4 % of its extent or more.
class EnergyJudge {
 public:
  void begin(const EnergyBudget::Totals& at, double negligible) {
    sums_.assign(kGiven + 2 * at.given.size(), 0.0);
    sums_[kKinetic] = at.kinetic;
    sums_[kStored] = at.stored;
    sums_[kNegligible] = negligible;
  }
  void note(const EnergyBudget::Totals& before, const EnergyBudget::Totals& after, double n) {
    sums_[kMade] -= n * (after.numerical - before.numerical);
    sums_[kReleased] = std::max(sums_[kReleased], sums_[kStored] - after.stored);
    for (std::size_t k = 0; k < after.given.size(); ++k) {
      double &sum = sums_[kGiven + 2 * k], &most = sums_[kGiven + 2 * k + 1];
      sum += n * (after.given[k] - before.given[k]);
      most = std::max(most, sum);
    }
    sums_[kInARow] = makes_too_much() ? sums_[kInARow] + 1 : 0;
  }

  double made() const { return sums_[kMade]; }
  double given() const {
    double all = sums_[kKinetic] + sums_[kReleased];
    for (std::size_t k = kGiven; k < sums_.size(); k += 2) all += sums_[k + 1];
    return all;
  }
  /// What energies are measured by: given and W [J].
  double scale() const { return given() + sums_[kNegligible]; }
  bool is_lost(bool at_the_end) const { return sums_[kInARow] >= (at_the_end ? 1 : 10); }
  std::string sentence() const {
    char text[128];
    std::snprintf(text, sizeof text,
                  "the motion is lost: %.3g J came out of nothing, where %.3g J were given", made(), given());
    return text;
  }

  /// All that it goes on from, and back.
  const std::vector<double>& sums() const { return sums_; }
  void set_sums(std::span<const double> sums) { sums_.assign(sums.begin(), sums.end()); }

 private:
  bool makes_too_much() const { return !(made() <= 0.5 * given() + sums_[kNegligible]); }

  enum : std::size_t { kMade, kKinetic, kStored, kReleased, kNegligible, kInARow, kGiven };
  std::vector<double> sums_;  // from kGiven on: of each k the sum and its maximum
};

}  // namespace netloft
