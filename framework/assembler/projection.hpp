// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

// For terms that offer no convex part or metric of their own, from their exact tangents. A term with
// HAS_CONVEX or HAS_METRIC is not touched by it.

/// The nearest positive semi-definite matrix to the symmetric part: negative eigenvalues are set to zero. Of
/// one element, full and row by row, `dofs` x `dofs`, in place. Slow.
void project_convex(double* tangent, int dofs);

/// Diagonals that bound the symmetric parts from above (Gershgorin), added to packed tangents; of the first
/// `count` lanes of a tile. Tangents are packed, too, if symmetric, else full.
void add_bounds(const double* tangent, bool symmetric, std::size_t dofs, std::size_t count,
                double* packed_tangent);

}  // namespace netloft
