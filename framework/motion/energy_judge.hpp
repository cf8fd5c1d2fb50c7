// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/energy_budget.hpp"

#include <algorithm>
#include <cstdio>

namespace netloft {

/// Decides whether a time scheme has created energy, so that the motion contains energy that nothing
/// supplied. Each examined step represents n steps. Δ is the change of an EnergyBudget::Totals over an
/// examined step; sums run over the examined steps, maxima over time. K₀ and E₀ are the kinetic and the
/// stored energy at the start, E the stored energy, and k counts holds, winches and nonconservative forces:
///   made = −Σ n Δnumerical                                                                (1)
///   given = K₀ + max(E₀ − E) + Σ_k max(Σ n Δgiven_k)                                       (2)
///   lost: made > ½ given + W, ten times in a row, or at the last examination                (3)
/// W [J] is a negligible work. A single violation is not enough, because a stable scheme may overshoot in its
/// first steps if they are far longer than the periods of the fast modes; the scheme removes this energy in
/// the following steps. In gear-library/scenes/dynamics, with all schemes and accuracies, made/given is at
/// most 0.15 in motions whose path is accurate to 2 %. In motions in which made/given reaches ½, it rises
/// further to 0.8 … 3·10⁸, and path errors are at least 4 % of the extent.
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
  double negligible() const { return sums_[kNegligible]; }
  /// The scale of energies: given + W [J].
  double scale() const { return given() + negligible(); }
  bool is_lost(bool at_the_end) const { return sums_[kInARow] >= (at_the_end ? 1 : 10); }
  std::string sentence() const {
    char text[128];
    std::snprintf(text, sizeof text,
                  "the motion is lost: the time scheme created %.3g J, whereas %.3g J were supplied", made(),
                  given());
    return text;
  }

  /// The sums and maxima of (1) to (3), which a resumed march needs to continue.
  const std::vector<double>& sums() const { return sums_; }
  void set_sums(std::span<const double> sums) { sums_.assign(sums.begin(), sums.end()); }

 private:
  bool makes_too_much() const { return !(made() <= 0.5 * given() + negligible()); }

  enum : std::size_t { kMade, kKinetic, kStored, kReleased, kNegligible, kInARow, kGiven };
  std::vector<double> sums_;  // from index kGiven on: for each k of (2), the sum and its maximum
};

}  // namespace netloft
