// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace netloft::studies {

/// The number Q(p) below which a fraction p of a sample lies, interpolated linearly between neighbours: type
/// 7 of R. J. Hyndman and Y. Fan, Sample quantiles in statistical packages, The American Statistician 50,
/// 1996. With the sorted sample x₀ ≤ … ≤ x_{n−1} and h = (n − 1) p,
///   Q(p) = x_⌊h⌋ + (h − ⌊h⌋) (x_{⌊h⌋+1} − x_⌊h⌋)                                           (1)
/// NaN for an empty sample; numbers that are not finite are ignored.
double quantile_of(std::vector<double> sample, double p);

double mean_of(const std::vector<double>& sample);
/// Standard deviation with the divisor n − 1; zero for a single number.
double deviation_of(const std::vector<double>& sample);

}  // namespace netloft::studies
