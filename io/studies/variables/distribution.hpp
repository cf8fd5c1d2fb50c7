// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/studies/variables/variable.hpp"

namespace netloft::studies {

/// The distribution of the samples of a variable over its interval from `low` to `high`. It maps a number p,
/// uniformly distributed in (0, 1), to a value of the variable. F is the standard normal distribution
/// function:
///   uniform       low + p (high − low)                                                     (1)
///   logarithmic   low (high/low)^p, low > 0                                                (2)
///   normal        mean + deviation F⁻¹(q), q from F at the low end to F at the high end    (3)
/// In (3), "F at an end" means F((end − mean)/deviation): the normal distribution is cut off at both ends.
struct Distribution {
  enum class Kind { uniform, logarithmic, normal };
  Kind kind = Kind::uniform;
  double mean = 0, deviation = 1;  // parameters of (3), in the variable's unit
};

/// F⁻¹ of (3), the quantile of the standard normal distribution; 0 < q < 1.
double normal_quantile(double q);

/// The value of the variable below which the fraction p of all samples lies.
double quantile(const Distribution& distribution, const Interval& interval, double p);

/// Reads the distribution of a variable with an interval from the table of that variable:
///   distribution = "normal"   or one of the other `kinds`, the first of which is the default
///   mean, deviation           for a normal one, numbers written like those of the range
Distribution read_distribution(const Variable& variable, formats::TableReader& table,
                               const std::vector<std::string>& kinds);

}  // namespace netloft::studies
