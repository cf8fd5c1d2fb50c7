// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace netloft {

/// The matrices of the eigenvalue problem K q = ω² M q as functions of a vector: y = K x, y = M x, y = M⁻¹ x.
/// K and M are symmetric, M is positive definite.
struct Pencil {
  using Apply = std::function<void(std::span<const double> x, std::span<double> y)>;
  std::size_t size = 0;
  Apply stiffness, mass, divide_by_mass;
};

/// The mode of the highest frequency, of length 1 in the inner product of M.
struct HighestMode {
  double omega = 0;  // angular frequency [rad/s], never too low except for rounding
  std::vector<double> shape;
};

/// Finds the mode by the Lanczos iteration in the inner product of M, with successive vectors q₋, q, q₊ of
/// length 1. ω² is the largest Ritz value of at most 60 steps plus its residual (C. Lanczos 1950; B. N.
/// Parlett, The Symmetric Eigenvalue Problem, 1980, chapter 13):
///   β q₊ = M⁻¹ K q − α q − β₋ q₋,  α = qᵀ K q                                              (1)
HighestMode find_highest_mode(const Pencil& pencil);

/// The highest frequency of a pencil (matrices K and M) similar to another one, whose highest mode is
/// `shape`. The iteration starts from this mode plus a small part of every other mode, so that it also finds
/// stiffer modes orthogonal to `shape`. It ends when the residual, which bounds the overestimate of ω², is at
/// most a twentieth of ω².
double highest_frequency_near(const Pencil& pencil, std::span<const double> shape);

}  // namespace netloft
