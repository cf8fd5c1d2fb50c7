// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

// Convex parts and metrics made from exact tangents, for terms that do not offer their own. A term with
// HAS_CONVEX or HAS_METRIC does not use these functions.

/// The nearest positive semi-definite matrix to the symmetric part: negative eigenvalues are set to zero.
/// `tangent` is that of one element, full, row by row, `dofs` x `dofs`, changed in place. Slow.
void project_convex(double* tangent, int dofs);

/// Adds to packed tangents diagonals that bound their symmetric parts from above (Gershgorin), for the first
/// `count` lanes of a tile. The input tangents are packed if symmetric, otherwise full.
void add_bounds(const double* tangent, bool symmetric, std::size_t dofs, std::size_t count,
                double* packed_tangent);

}  // namespace netloft
