// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

// These functions derive convex parts and metrics from exact tangents, for terms that do not offer their own
// (traits HAS_CONVEX and HAS_METRIC).

/// Replaces the tangent of one element by the positive semi-definite matrix nearest to its symmetric part:
/// negative eigenvalues become zero. `tangent` has `dofs` x `dofs` entries, row by row. This is slow.
void project_convex(double* tangent, int dofs);

/// Adds diagonal matrices to `packed_tangent` that bound the symmetric parts of `tangent` from above
/// (Gershgorin), for the first `count` elements of a tile. `tangent` is packed if `symmetric`, otherwise
/// full.
void add_bounds(const double* tangent, bool symmetric, std::size_t dofs, std::size_t count,
                double* packed_tangent);

}  // namespace netloft
