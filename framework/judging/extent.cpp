// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/extent.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// Largest number of separate local motions, each of which costs another search for growing motions. The value
// is chosen: of 201 equilibria of the trawl 83-112 at sea, 8 had local motions.
constexpr int kLocalMotions = 3;

/// The mass of the gear. Each of the three unknowns of a node counts a third of the mass of the node.
double mass_of(const SparsePattern& pattern, const LinearMotion& motion) {
  double trace = 0;
  for_entries(
      pattern, [&](std::int32_t r, std::int32_t c, double mass) { trace += r == c ? mass : 0; }, motion.M);
  return trace / 3;
}

/// Returns yᵀM y.
double square_by_mass(const SparsePattern& pattern, const LinearMotion& motion,
                      const std::vector<double>& y) {
  double sum = 0;
  const auto add = [&](std::int32_t r, std::int32_t c, double mass) {
    sum += y[static_cast<std::size_t>(r)] * mass * y[static_cast<std::size_t>(c)];
  };
  if (!y.empty()) for_entries(pattern, add, motion.M);
  return sum;
}

/// The share (1) of extent.hpp: the fraction of the gear's mass that a motion with these nodal amplitudes
/// moves.
double share_of(const SparsePattern& pattern, const LinearMotion& motion, const Growth& growth,
                const std::vector<double>& amplitudes) {
  const double furthest = *std::max_element(amplitudes.begin(), amplitudes.end());
  const double moved =
      square_by_mass(pattern, motion, growth.mode) + square_by_mass(pattern, motion, growth.mode_later);
  const double share = moved / (furthest * furthest * mass_of(pattern, motion));
  return share >= 0 ? share : 1;
}

/// Holds unknowns by making each one a damped oscillator that is coupled to no other unknown.
void hold(const SparsePattern& pattern, const std::vector<bool>& is_held, LinearMotion& motion) {
  for (std::int32_t c = 0; c < pattern.size; ++c)
    for (auto k = static_cast<std::size_t>(pattern.column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(pattern.column_start[static_cast<std::size_t>(c) + 1]); ++k) {
      const std::int32_t r = pattern.row[k];
      if (!is_held[static_cast<std::size_t>(r)] && !is_held[static_cast<std::size_t>(c)]) continue;
      const std::size_t slot = pattern.slot_of(k);
      const double stiffness = r == c ? motion.convex[slot] : 0, mass = r == c ? motion.M[slot] : 0;
      motion.K[slot] = motion.convex[slot] = stiffness;
      motion.M[slot] = mass;
      motion.C[slot] = 2 * std::sqrt(stiffness * mass);
    }
}

void hold_moving_nodes(const Assembler& assembler, const std::vector<double>& amplitudes,
                       LinearMotion& motion) {
  const Numbering& numbering = assembler.numbering();
  const double furthest = *std::max_element(amplitudes.begin(), amplitudes.end());
  std::vector<bool> is_held(static_cast<std::size_t>(numbering.unknowns()));
  for (std::size_t i = 0; i < is_held.size(); ++i)
    is_held[i] = amplitudes[numbering.node(Dof(i))] >= kMoves * furthest;
  hold(assembler.pattern(), is_held, motion);
}

}  // namespace

std::vector<double> node_amplitudes(const Numbering& numbering, const std::vector<double>& mode,
                                    const std::vector<double>& mode_later) {
  std::vector<double> amplitudes;
  for (const auto* u : {&mode, &mode_later})
    for (std::size_t i = 0; i < u->size(); ++i) {
      const std::size_t node = numbering.node(Dof(i));
      if (node >= amplitudes.size()) amplitudes.resize(node + 1, 0.0);
      amplitudes[node] += (*u)[i] * (*u)[i];
    }
  for (double& square : amplitudes) square = std::sqrt(square);
  return amplitudes;
}

void find_extent(const Assembler& assembler, LinearMotion& motion, Factors& factors, Growth& growth) {
  const SparsePattern& pattern = assembler.pattern();
  growth.share = 0;
  Growth more = growth;
  for (int found = 0; more.grows(); ++found) {
    if (more.mode.empty()) growth.share = 1;
    if (growth.share > kMatters || found == kLocalMotions) return;
    const auto amplitudes = node_amplitudes(assembler.numbering(), more.mode, more.mode_later);
    growth.share += share_of(pattern, motion, more, amplitudes);
    if (growth.share > kMatters) return;
    hold_moving_nodes(assembler, amplitudes, motion);
    more = find_growth(pattern, motion, factors);
  }
  growth.is_local = more.verdict == GrowthVerdict::none || more.verdict == GrowthVerdict::marginal;
}

}  // namespace netloft
