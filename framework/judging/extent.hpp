// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/growth.hpp"

namespace netloft {

/// A node takes part in a growing motion if its amplitude is at least this fraction of the largest amplitude.
inline constexpr double kMoves = 0.1;

/// The amplitude of each node in a motion that has the shape `mode` and, a quarter of a period later, the
/// shape `mode_later`, both given for all unknowns. An empty `mode_later` means that the motion does not
/// oscillate.
std::vector<double> node_amplitudes(const Numbering& numbering, const std::vector<double>& mode,
                                    const std::vector<double>& mode_later);

/// Sets Growth::share and is_local of a growing motion. The share is a mass divided by the mass of the gear.
/// If all of this mass moved as far as the furthest node, it would have the kinetic energy of the motion:
///   share = Σ yᵀM y/(d² m),   m = ⅓ tr M                                                  (1)
/// y stands for the mode and the mode a quarter of a period later; d is the largest amplitude of a node. Both
/// masses include added mass. The motion is local if its share is at most kMatters and nothing grows any more
/// when the nodes that take part are held. If another motion still grows, its nodes are held as well, and so
/// on for at most kLocalMotions motions, whose shares are added. Changes the matrices of `motion`.
void find_extent(const Assembler& assembler, LinearMotion& motion, Factors& factors, Growth& growth);

}  // namespace netloft
