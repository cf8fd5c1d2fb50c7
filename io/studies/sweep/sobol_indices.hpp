// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/estimate.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace netloft::studies {

/// The fraction of a function's variance that one of its variables causes.
struct SobolIndex {
  WithError first;  // fraction caused by the variable alone
  WithError total;  // fraction caused by the variable and its interactions with others
};

struct SobolIndices {
  double mean = 0, deviation = 0;  // mean and deviation of the function
  std::vector<SobolIndex> variables;
};

/// The size of the sample: `points` (d + 2) evaluations per replicate, where d is the number of variables.
struct SobolSample {
  std::size_t points = 512;  // a power of two, which Sobol's sequence fills evenly
  std::size_t replicates = 8;
};

/// A function of independent variables, each of them uniform from zero to one.
using UnitFunction = std::function<double(const std::vector<double>&)>;

/// Sobol's indices of first order and total (I. M. Sobol, Mathematics and Computers in Simulation 55, 2001).
/// Each of N points of Sobol's sequence in 2 d dimensions gives two points a and b in d dimensions. c_i is
/// the point a with its variable i replaced by that of b. The sums are over the N points:
///   S_i = 1/N Σ f(b) (f(c_i) − f(a)) / V                                                    (1)
///   T_i = 1/(2N) Σ (f(a) − f(c_i))² / V                                                     (2)
/// V is the variance of f over all points a and b; in (1) the mean of f is subtracted. (1): A. Saltelli et
/// al., Computer Physics Communications 181, 2010; (2): M. J. W. Jansen, Computer Physics Communications 117,
/// 1999. The indices are means over several replicates, whose sequences differ by a random digital shift; the
/// errors are twice the standard deviation of these means. The points are the same in every call. A constant
/// function has the indices zero.
SobolIndices sobol_indices(const UnitFunction& f, std::size_t variables, const SobolSample& sample = {});

}  // namespace netloft::studies
