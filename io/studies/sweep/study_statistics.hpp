// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace netloft::studies {

/// The number below which a fraction p of a sample lies, between neighbours in proportion (type 7 of R. J.
/// Hyndman and Y. Fan, Sample quantiles in statistical packages, The American Statistician 50, 1996): with x₀
/// ≤ … ≤ x_{n−1} and h = (n − 1) p,
///   Q(p) = x_⌊h⌋ + (h − ⌊h⌋) (x_{⌊h⌋+1} − x_⌊h⌋)                                           (1)
/// NaN of an empty sample; numbers that are not finite do not count.
double quantile_of(std::vector<double> sample, double p);

double mean_of(const std::vector<double>& sample);
/// With n − 1; zero of a single number.
double deviation_of(const std::vector<double>& sample);

}  // namespace netloft::studies
