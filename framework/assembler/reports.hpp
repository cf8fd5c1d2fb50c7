// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/bodies.hpp"
#include "framework/assembler/frames.hpp"
#include "framework/assembler/tile_evaluator.hpp"

#include <span>
#include <vector>

namespace netloft {

/// Evaluations for reports: forces and energies of single terms, outputs of elements, and the use of laws
/// outside their ranges. All functions run on one thread. `x` are positions over all dofs, `family` is an
/// index among the families of the assembler, and `term` an index among the active terms of the family. A
/// false result means that an element could not be evaluated: see Assembler::fault().
class ElementReports {
 public:
  /// The arguments must outlive this object.
  ElementReports(TileEvaluator& elements, Bodies& bodies, const Frames& frames)
      : elements_(elements), bodies_(bodies), frames_(frames) {}

  /// Force of one term alone, as a residual over all dofs [N].
  bool evaluate_term(std::span<const double> x, std::size_t family, std::size_t term,
                     std::span<double> residual, const Kinematics& motion = {});
  /// Force of all terms for whose traits `counts` is true, as a residual over all dofs [N]. Terms that cannot
  /// be evaluated are left out.
  std::vector<double> sum_terms(std::span<const double> x, bool (*counts)(std::uint32_t traits));
  /// Energy of one term alone [J]; zero if it has none.
  bool term_energy(std::span<const double> x, std::size_t family, std::size_t term, double& energy,
                   const Kinematics& motion = {});
  /// Sums the residual (+dE/dx) of a term over the nodes of each part of the family [N]: 3 numbers per part.
  bool sum_term(std::span<const double> x, std::size_t family, std::size_t term, std::span<double> sums,
                const Kinematics& motion = {});
  /// Sums the residual of one term over each group of nodes, for each part [N]: 3 numbers per part and group.
  /// `groups` has a group index for each node of the scene; a negative index means no group.
  bool sum_term_at(std::span<const double> x, std::size_t family, std::size_t term,
                   std::span<const std::int32_t> groups, std::size_t group_count, std::span<double> sums,
                   const Kinematics& motion = {});
  /// Outputs of a family, [output][element]. An output that cannot be computed is NaN; the result is then
  /// false.
  bool outputs(std::span<const double> x, std::size_t family, std::vector<std::vector<double>>& values,
               const Kinematics& motion = {});
  /// How much each law is used, at positions x, inside and outside the ranges in which it was measured: one
  /// entry per family and law with a range.
  std::vector<LawUse> find_law_use(std::span<const double> x, const Kinematics& motion = {});

 private:
  const ElementFamily& family_at(std::size_t family) const;
  bool add_term(std::span<const double> x, std::size_t family, std::size_t term, std::span<double> residual,
                const Kinematics& motion);

  TileEvaluator& elements_;
  Bodies& bodies_;
  const Frames& frames_;
};

}  // namespace netloft
