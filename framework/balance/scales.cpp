// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/scales.hpp"

#include "framework/assembler/reports.hpp"

#include <algorithm>

namespace netloft {

namespace {

/// Largest distance along an axis, at the start, between the first node and another node [m]; at least 1.
/// Ignores degrees of freedom that are not positions.
double largest_distance(const Assembler& assembler) {
  const std::vector<double>& x = assembler.start();
  double largest = 1;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (assembler.is_place(i)) largest = std::max(largest, std::abs(x[i] - x[i % 3]));
  return largest;
}

}  // namespace

double largest_extent(const Assembler& assembler, std::span<const double> x) {
  double largest = 0;
  const Numbering& numbering = assembler.numbering();
  const auto at = [&](std::uint32_t node, int axis) { return x[numbering.dof(node, axis).at()]; };
  for (const auto& family : assembler.families())
    for (std::size_t e = 0; e < family->size(); ++e)
      for (int corner = 1; corner < family->nodes_per_element(); ++corner)
        for (int axis = 0; axis < 3; ++axis)
          largest =
              std::max(largest, std::abs(at(family->node(e, corner), axis) - at(family->node(e, 0), axis)));
  return largest;
}

Scales::Scales(Assembler& assembler) : assembler_(assembler), gear_size_(largest_distance(assembler)) {
  if (const double largest = largest_extent(assembler, assembler.start()); largest > 0)
    element_size_ = largest;
  const auto dead = assembler.reports().sum_terms(
      assembler.start(), [](std::uint32_t traits) { return (traits & NETLOFT_CONSTANT) != 0; });
  for_nodes(assembler.numbering(), 0, assembler.pattern().size, dead,
            [&](std::uint32_t, double norm, std::int32_t, std::int32_t) {
              dead_load_ = std::max(dead_load_, norm);
            });
}

Scales::DrivingLoad Scales::driving_load() {
  const auto sum = assembler_.reports().sum_terms(assembler_.start(), [](std::uint32_t traits) {
    return (traits & NETLOFT_CONSTANT) != 0 || (traits & NETLOFT_CONSERVATIVE) == 0;
  });
  DrivingLoad load;
  for_nodes(assembler_.numbering(), 0, assembler_.pattern().size, sum,
            [&](std::uint32_t, double norm, std::int32_t, std::int32_t) {
              load.largest = std::max(load.largest, norm);
              load.sum += norm;
            });
  return load;
}

bool Scales::is_driven(std::span<const double> x) {
  if (!is_driven_) {
    const auto sum = assembler_.reports().sum_terms(x, [](std::uint32_t traits) {
      return (traits & (NETLOFT_CONSTANT | NETLOFT_FROM_OUTSIDE)) != 0 ||
             (traits & NETLOFT_CONSERVATIVE) == 0;
    });
    is_driven_ = std::any_of(sum.begin(), sum.end(), [](double force) { return force != 0; });
  }
  return *is_driven_;
}

}  // namespace netloft
