// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/bodies.hpp"
#include "framework/assembler/frames.hpp"
#include "framework/assembler/tile_evaluator.hpp"

#include <span>
#include <vector>

namespace netloft {

/// Evaluations for reports: forces and energies of single terms, outputs of elements, and the use of laws
/// outside their ranges. Serial. `x` are positions over all dofs, `family` is an index among the families of
/// the assembler, and `term` an index among the active terms of the family. A false result means that an
/// element could not be evaluated: see Assembler::fault().
class ElementReports {
 public:
  /// The objects have to outlive this one.
  ElementReports(TileEvaluator& elements, Bodies& bodies, const Frames& frames)
      : elements_(elements), bodies_(bodies), frames_(frames) {}

  /// Force of one term alone, as a residual over all dofs [N].
  bool evaluate_term(std::span<const double> x, std::size_t family, std::size_t term,
                     std::span<double> residual, const Kinematics& motion = {});
  /// Energy of one term alone [J]; zero if it has none.
  bool term_energy(std::span<const double> x, std::size_t family, std::size_t term, double& energy,
                   const Kinematics& motion = {});
  /// Force of one term summed per part of the family, +dE/dx [N]: 3 numbers per part.
  bool sum_term(std::span<const double> x, std::size_t family, std::size_t term, std::span<double> sums,
                const Kinematics& motion = {});
  /// Force of one term summed per part and group of nodes [N]: 3 numbers per part and group. `groups` has the
  /// index of the group of each node of the scene; it is negative for nodes without a group.
  bool sum_term_at(std::span<const double> x, std::size_t family, std::size_t term,
                   std::span<const std::int32_t> groups, std::size_t group_count, std::span<double> sums,
                   const Kinematics& motion = {});
  /// Outputs of a family, [output][element]. An output that could not be computed is NaN; the result is then
  /// false.
  bool outputs(std::span<const double> x, std::size_t family, std::vector<std::vector<double>>& values,
               const Kinematics& motion = {});
  /// Use of each law at x inside and outside the ranges in which it was measured: one entry per family and
  /// law that has a range.
  std::vector<LawUse> find_law_use(std::span<const double> x, const Kinematics& motion = {});

 private:
  const ElementFamily& family_at(std::size_t family) const;

  TileEvaluator& elements_;
  Bodies& bodies_;
  const Frames& frames_;
};

}  // namespace netloft
