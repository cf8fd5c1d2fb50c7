// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace netloft {

/// K and M of K q = ω² M q, by what they do to a vector: y = K x, y = M x, y = M⁻¹ x. Symmetric, M definite.
struct Pencil {
  using Apply = std::function<void(std::span<const double> x, std::span<double> y)>;
  std::size_t size = 0;
  Apply stiffness, mass, divide_by_mass;
};

/// The mode of the highest frequency, of length 1 in the inner product of M.
struct HighestMode {
  double omega = 0;  // [rad/s], from above but for rounding
  std::vector<double> shape;
};

/// ω² is the largest Ritz value of at most 60 Lanczos steps in the inner product of M, and its residual (C.
/// Lanczos 1950; B. N. Parlett, The Symmetric Eigenvalue Problem, 1980, chapter 13):
///   β q₊ = M⁻¹ K q − α q − β₋ q₋,  α = qᵀ K q                                              (1)
HighestMode find_highest_mode(const Pencil& pencil);

/// The frequency alone, of a pencil like the one whose mode is known: from this mode and a little of
/// everything, so that stiffer modes that are orthogonal to it are seen, too. Ends once the residual is a
/// twentieth of ω², which it is above the truth by then.
double highest_frequency_near(const Pencil& pencil, std::span<const double> shape);

}  // namespace netloft
