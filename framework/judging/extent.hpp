// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/growth.hpp"

namespace netloft {

/// Least amplitude, as a fraction of the largest one, at which a node counts as moving with a growing motion.
inline constexpr double kMoves = 0.1;

/// The amplitude of each node in a motion with the shape `mode` and, a quarter of a period later,
/// `mode_later`, both over the unknowns. An empty `mode_later` means that the motion does not oscillate.
std::vector<double> node_amplitudes(const Numbering& numbering, const std::vector<double>& mode,
                                    const std::vector<double>& mode_later);

/// Sets Growth::share and is_local of a growing motion. The share is the mass that would have the kinetic
/// energy of the motion if it moved as far as the furthest node, over the mass of the gear:
///   share = Σ yᵀM y/(d² m),   m = ⅓ tr M                                                  (1)
/// y are the mode and the mode a quarter of a period later, and d is the largest amplitude of a node. Both
/// masses include added mass. The motion is local if its share is at most kMatters, and nothing grows any
/// more when the nodes that move are held. If something still grows, the same holds for its motion, at most
/// kLocalMotions times and with the sum of the shares. Changes the matrices of `motion`.
void find_extent(const Assembler& assembler, LinearMotion& motion, Factors& factors, Growth& growth);

}  // namespace netloft
