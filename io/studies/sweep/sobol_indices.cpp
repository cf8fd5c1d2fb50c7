// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/sobol_indices.hpp"

#include "io/studies/sweep/study_statistics.hpp"
#include "io/studies/sweep/unit_points.hpp"

#include <cmath>
#include <utility>

namespace netloft::studies {

namespace {

using Numbers = std::vector<double>;

/// Function values of one replicate at the points a, b and c_i of sobol_indices.hpp; `c` has one list for
/// each variable i.
struct TripleOfValues {
  Numbers a, b;
  std::vector<Numbers> c;
};

TripleOfValues evaluate(const UnitFunction& f, std::size_t d, std::size_t points, std::uint64_t seed) {
  TripleOfValues values{{}, {}, std::vector<Numbers>(d)};
  for (const Numbers& both : unit_points(Sampling::sobol, points, 2 * d, seed)) {
    const auto middle = both.begin() + static_cast<std::ptrdiff_t>(d);
    Numbers row(both.begin(), middle);
    values.a.push_back(f(row));
    values.b.push_back(f({middle, both.end()}));
    for (std::size_t i = 0; i < d; ++i) {
      const double kept = std::exchange(row[i], both[d + i]);
      values.c[i].push_back(f(row));
      row[i] = kept;
    }
  }
  return values;
}

/// The indices, (1) and (2) in sobol_indices.hpp, of one replicate, and the mean and deviation of the
/// function.
SobolIndices indices_of(const TripleOfValues& values) {
  Numbers all = values.a;
  all.insert(all.end(), values.b.begin(), values.b.end());
  SobolIndices indices{mean_of(all), deviation_of(all), std::vector<SobolIndex>(values.c.size())};
  if (!(indices.deviation > 0)) return indices;
  const auto n = static_cast<double>(values.a.size());
  const double variance = indices.deviation * indices.deviation;
  for (std::size_t i = 0; i < values.c.size(); ++i) {
    double first = 0, total = 0;
    for (std::size_t j = 0; j < values.a.size(); ++j) {
      const double step = values.c[i][j] - values.a[j];
      first += (values.b[j] - indices.mean) * step;
      total += step * step;
    }
    indices.variables[i] = {{first / (n * variance), 0}, {total / (2 * n * variance), 0}};
  }
  return indices;
}

/// The mean of a number over the replicates, and twice the standard deviation of this mean.
WithError mean_over(const std::vector<SobolIndices>& all,
                    const std::function<double(const SobolIndices&)>& take) {
  Numbers numbers;
  for (const SobolIndices& one : all) numbers.push_back(take(one));
  return {mean_of(numbers), 2 * deviation_of(numbers) / std::sqrt(static_cast<double>(numbers.size()))};
}

}  // namespace

SobolIndices sobol_indices(const UnitFunction& f, std::size_t variables, const SobolSample& sample) {
  std::vector<SobolIndices> all;
  for (std::size_t r = 0; r < sample.replicates; ++r)
    all.push_back(indices_of(evaluate(f, variables, sample.points, r + 1)));
  SobolIndices mean;
  mean.mean = mean_over(all, [](const auto& one) { return one.mean; }).value;
  mean.deviation = mean_over(all, [](const auto& one) { return one.deviation; }).value;
  for (std::size_t i = 0; i < variables; ++i)
    mean.variables.push_back({mean_over(all, [i](const auto& one) { return one.variables[i].first.value; }),
                              mean_over(all, [i](const auto& one) { return one.variables[i].total.value; })});
  return mean;
}

}  // namespace netloft::studies
