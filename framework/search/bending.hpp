// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factors.hpp"

namespace netloft {

// Here, bending stands for all elastic forces that are not tensions or compressions of members: those of
// meshes that resist opening, and of ropes and netting that resist bending. They have an energy, depend on
// the shape and act between nodes only. Because their energy is the same for a shape and for its enlargement,
// it is not convex.

/// Whether some active term of the scene is bending.
bool resists_bending(const Assembler& assembler);

/// Largest force of bending on a node, along one axis, at displacements u of the unknowns [N]. It is zero
/// unless bending holds the gear in this shape: unless the tangent of all other forces is not positive
/// definite. If it is, and nothing in compression bears a load, the shape is the only one under these
/// forces of bending. All forces must have an energy. Costs one factorisation, which `factors` counts.
double bending_that_holds(Assembler& assembler, std::span<const double> u, Factors& factors);

}  // namespace netloft
