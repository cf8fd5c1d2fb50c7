// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

/// For terms that offer no convex part or metric of their own: makes them from the exact tangent of one
/// element, full and row by row, `dofs` x `dofs`, in place. Slow; a term with HAS_CONVEX is not touched by
/// it.

/// The nearest positive semi-definite matrix to the symmetric part: negative eigenvalues are set to zero.
void project_convex(double* tangent, int dofs);

/// A diagonal that bounds the symmetric part from above (Gershgorin).
void bound_by_diagonal(double* tangent, int dofs);

}  // namespace netloft
