// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/shapes.hpp"

#include "framework/judging/correction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace netloft {

namespace {

// Energies count as equal if they differ by at most this fraction of the energy, or of the product of the
// largest load and the size of the gear. Near an equilibrium, the energy changes by about this much over the
// largest distance at which points count as the same.
constexpr double kSameEnergy = kTolerance;

bool has_converged(const Solution& s) { return s.status == SolveStatus::converged; }

}  // namespace

EquilibriumChoice::EquilibriumChoice(const Scene& scene, const Assembler& assembler, double gear_size,
                                     bool has_energy)
    : scene_(scene), assembler_(assembler), gear_size_(gear_size), has_energy_(has_energy) {}

void EquilibriumChoice::add(Solution solution) {
  ++answers_;
  const auto known =
      std::find_if(begin(found_), end(found_), [&](const Found& f) { return is_same(f.solution, solution); });
  if (known == end(found_)) return found_.push_back({std::move(solution)});
  ++known->times;
  const bool is_closer = solution.balance.residual < known->solution.balance.residual;
  if (has_converged(solution) && (is_closer || !has_converged(known->solution)))
    known->solution = std::move(solution);
}

Solution EquilibriumChoice::best() const {
  assert(!found_.empty());
  auto at = begin(found_);
  for (auto other = begin(found_) + 1; other != end(found_); ++other)
    if (is_better(other->solution, at->solution)) at = other;
  Solution best = at->solution;
  best.shapes.restarts = answers_ - 1;
  best.shapes.times = at->times;
  best.shapes.by_energy = has_energy_;
  for (auto other = begin(found_); other != end(found_); ++other) {
    if (other == at || !has_converged(other->solution)) continue;
    const auto [distance, node] = furthest_node(scene_, assembler_.numbering(), best.x, other->solution.x);
    best.shapes.others.push_back({other->solution.energy, distance, assembler_.node_name(scene_, node),
                                  other->times, other->solution.x});
  }
  return best;
}

bool EquilibriumChoice::is_better(const Solution& a, const Solution& b) const {
  if (has_converged(a) != has_converged(b)) return has_converged(a);
  return has_energy_ && has_converged(a) && a.energy < b.energy - energy_noise(a, b);
}

bool EquilibriumChoice::is_same(const Solution& a, const Solution& b) const {
  if (largest_node_distance(scene_, assembler_.numbering(), a.x, b.x) <= kSamePlace * gear_size_) return true;
  return has_energy_ && a.stability == Stability::neutral && b.stability == Stability::neutral &&
         std::abs(a.energy - b.energy) <= energy_noise(a, b);
}

double EquilibriumChoice::energy_noise(const Solution& a, const Solution& b) const {
  return kSameEnergy * std::max({std::abs(a.energy), std::abs(b.energy), a.balance.scale * gear_size_});
}

}  // namespace netloft
