// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

// Convex parts and metrics for terms that do not offer them (traits HAS_CONVEX and HAS_METRIC), derived from
// exact tangents.

/// Replaces the tangent of one element by the positive semi-definite matrix nearest to its symmetric part:
/// negative eigenvalues become zero. `tangent` has `dofs` x `dofs` entries, row by row. This is slow.
void project_convex(double* tangent, int dofs);

/// Adds diagonal matrices to `packed_tangent`, for the first `count` elements of a tile. The diagonal
/// matrices bound the symmetric parts of `tangent` from above (Gershgorin's theorem). `tangent` is stored as
/// a packed triangle if `symmetric`, otherwise as a full square.
void add_bounds(const double* tangent, bool symmetric, std::size_t dofs, std::size_t count,
                double* packed_tangent);

}  // namespace netloft
