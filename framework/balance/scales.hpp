// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace netloft {

/// Calls visit(node, norm, first, last) for each node that has entries in the range begin … end - 1 of a
/// vector over all dofs. The entries of a node are first … last - 1, and `norm` is their norm.
template <class Visit>
void for_nodes(const Numbering& numbering, std::int32_t begin, std::int32_t end, std::span<const double> v,
               Visit&& visit) {
  for (std::int32_t i = begin; i < end;) {
    const std::uint32_t node = numbering.node(Dof(i));
    const std::int32_t first = i;
    double sum = 0;
    for (; i < end && numbering.node(Dof(i)) == node; ++i)
      sum += v[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(i)];
    visit(node, std::sqrt(sum), first, i);
  }
}

/// Longest extent of an element along an axis at positions x over all degrees of freedom [m].
double largest_extent(const Assembler& assembler, std::span<const double> x);

/// Lengths and loads of a scene at its start, to which residuals and steps are compared.
class Scales {
 public:
  explicit Scales(Assembler& assembler);

  /// Longest extent of an element [m]; 1 if there is none.
  double element_size() const { return element_size_; }
  /// Largest distance along an axis, at the start, between the first node and another node [m]; at least 1.
  double gear_size() const { return gear_size_; }
  /// Largest dead load on a node, that is, of forces that do not depend on the state [N].
  double dead_load() const { return dead_load_; }

  /// Forces that drive the gear: dead loads, which do not depend on the state (such as weight), and forces
  /// that have no potential (such as drag).
  struct DrivingLoad {
    double largest = 0, sum = 0;  // norms of nodal forces: the largest, and their sum over all nodes [N]
  };
  DrivingLoad driving_load();
  /// Whether an external force acts on the elements. The first call determines this at positions x; later
  /// calls return the same value.
  bool is_driven(std::span<const double> x);

 private:
  Assembler& assembler_;
  double element_size_ = 1, gear_size_ = 1, dead_load_ = 0;
  std::optional<bool> is_driven_;  // nullopt before the first call
};

}  // namespace netloft
