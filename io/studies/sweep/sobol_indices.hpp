// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/estimate.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace netloft::studies {

/// How much of the variance of a function follows from one of its variables.
struct SobolIndex {
  WithError first;  // from the variable alone
  WithError total;  // from the variable alone and together with others
};

struct SobolIndices {
  double mean = 0, deviation = 0;  // of the function
  std::vector<SobolIndex> variables;
};

/// Points at which a function is evaluated: `points` (d + 2) of every replicate, d its variables.
struct SobolSample {
  std::size_t points = 512;  // a power of two, which Sobol's sequence fills evenly
  std::size_t replicates = 8;
};

/// A function of independent variables, each of them uniform from zero to one.
using UnitFunction = std::function<double(const std::vector<double>&)>;

/// Sobol's indices of first order and total (I. M. Sobol, Mathematics and Computers in Simulation 55, 2001).
/// With rows a and b of two samples of N points, a point of Sobol's sequence in 2 d dimensions for both, and
/// c_i the row a with variable i of b,
///   S_i = 1/N Σ f(b) (f(c_i) − f(a)) / V                                                    (1)
///   T_i = 1/(2N) Σ (f(a) − f(c_i))² / V                                                     (2)
/// V the variance of f over both samples, f less its mean in (1). (1): A. Saltelli et al., Computer Physics
/// Communications 181, 2010; (2): M. J. W. Jansen, Computer Physics Communications 117, 1999. Indices are
/// means over replicates, sequences that are shifted digit by digit; errors are twice the deviation of these
/// means. The same points every time. A function that is constant has indices of zero.
SobolIndices sobol_indices(const UnitFunction& f, std::size_t variables, const SobolSample& sample = {});

}  // namespace netloft::studies
