// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft::studies {

/// The method that distributes samples in the space of their variables.
enum class Sampling { latin_hypercube, sobol };

/// The largest number of dimensions for which Sobol's sequence has direction numbers.
inline constexpr std::size_t kMostSobolVariables = 3667;

/// Returns `count` points in the open unit cube of `dimensions` dimensions. The points are the same on every
/// machine.
///   latin_hypercube   every dimension is divided into `count` equal intervals with one random point in
///                     each; the order of the intervals is random (McKay, Beckman and Conover, Technometrics
///                     21, 1979)
///   sobol             Sobol's sequence with the direction numbers of Joe and Kuo (SIAM J. Sci. Comput. 30,
///                     2008), every dimension shifted digit by digit by a random number, so that points keep
///                     their distribution and differ between seeds; counts that are powers of two fill evenly
std::vector<std::vector<double>> unit_points(Sampling sampling, std::size_t count, std::size_t dimensions,
                                             std::uint64_t seed);

}  // namespace netloft::studies
