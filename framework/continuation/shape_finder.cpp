// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/shape_finder.hpp"

#include "framework/problem/correction.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// Of the gear's size; of the energy, or of the work of the largest load over the gear's size.
constexpr double kSamePlace = 1e-5, kSameEnergy = 1e-9;

}  // namespace

ShapeFinder::ShapeFinder(const Scene& scene, const Assembler& assembler, double gear_size, bool energies_tell)
    : scene_(scene), assembler_(assembler), gear_size_(gear_size), energies_tell_(energies_tell) {}

void ShapeFinder::add(Solution solution) {
  ++looks_;
  if (found_.empty()) return found_.push_back({std::move(solution)});
  if (solution.status != SolveStatus::converged) return;
  const auto known =
      std::find_if(begin(found_), end(found_), [&](const Found& f) { return is_same(f.solution, solution); });
  if (known != end(found_))
    ++known->times;
  else
    found_.push_back({std::move(solution)});
}

Solution ShapeFinder::best() {
  auto at = begin(found_);
  if (energies_tell_)
    for (auto other = begin(found_) + 1; other != end(found_); ++other)
      if (other->solution.energy < at->solution.energy - energy_noise(at->solution, other->solution))
        at = other;
  Solution best = at->solution;
  best.shapes.looks = looks_, best.shapes.times = at->times;
  for (auto other = begin(found_); other != end(found_); ++other) {
    if (other == at) continue;
    const auto [distance, node] = furthest_node(scene_, assembler_.numbering(), best.x, other->solution.x);
    best.shapes.others.push_back(
        {other->solution.energy, distance, assembler_.node_name(scene_, node), other->times});
  }
  return best;
}

bool ShapeFinder::is_same(const Solution& a, const Solution& b) const {
  if (largest_node_distance(scene_, assembler_.numbering(), a.x, b.x) <= kSamePlace * gear_size_) return true;
  return energies_tell_ && a.stability == Stability::neutral && b.stability == Stability::neutral &&
         std::abs(a.energy - b.energy) <= energy_noise(a, b);
}

double ShapeFinder::energy_noise(const Solution& a, const Solution& b) const {
  return kSameEnergy * std::max({std::abs(a.energy), std::abs(b.energy), a.balance.scale * gear_size_});
}

}  // namespace netloft
