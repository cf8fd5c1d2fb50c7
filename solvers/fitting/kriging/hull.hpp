// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace netloft {

/// Whether a point x is in the convex hull of the points x_i: whether there are λ ≥ 0 with
///   Σ λ_i x_i = x,  Σ λ_i = 1                                                                     (1)
/// The λ are found by least squares with λ ≥ 0 (C. L. Lawson, R. J. Hanson, Solving least squares problems,
/// 1974, ch. 23). Coordinates must be of about the size of one; within 1e-9 of the hull, x counts as inside.
bool lies_in_hull(const std::vector<std::vector<double>>& points, const std::vector<double>& point);

}  // namespace netloft
