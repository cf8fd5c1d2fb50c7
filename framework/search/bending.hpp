// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factors.hpp"

namespace netloft {

// Bending, in this header, means every elastic force except the tension and compression of members: netting
// that resists the opening of its meshes, and ropes and netting that resist bending. These forces have a
// potential and act between nodes only. The potential is not convex: it depends on the shape, but not on its
// size.

/// Whether some active term of the scene is bending.
bool resists_bending(const Assembler& assembler);

/// Largest force of bending on a node, along one axis, at displacements u of the unknowns [N]; zero if the
/// tangent of all other forces is positive definite. In that case, the other forces alone keep the gear in
/// this shape. If, moreover, no load is borne in compression, no other shape is in balance with the same
/// bending forces. All forces must have a potential. Costs one factorisation, which `factors` counts.
double bending_that_holds(Assembler& assembler, std::span<const double> u, Factors& factors);

}  // namespace netloft
