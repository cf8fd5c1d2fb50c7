// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"

namespace netloft {

/// Whether a flow changes the water of a term of a family, so that a ChangedWater evaluates the term.
bool is_in_changed_water(const FamilyPlan& family, const TermPlan& term);

/// The drag of the elements of a family in water that a flow (ext/flow.h) changes. With the residual r(x, v,
/// c) of an element, the undisturbed velocity U of the water, and the unknowns a and weights g of the flow:
///   c = w(U, a, n)                                           velocity of the water at a corner    (1)
///   R_k += Σ g_k(U) · r                                      part of equation k of the flow       (2)
///   ∂r/∂c = −∂r/∂v                         drag depends on the relative velocity c − v only       (3)
///   ∂r/∂a_k = −∂r/∂v ∂w/∂a_k                                                                      (4)
///   ∂R_k/∂x = Σ (g_k · ∂r/∂x + r · ∂g_k/∂U ∂U/∂x),   ∂R_k/∂a_l = Σ g_k · ∂r/∂a_l                  (5)
///   n = N/D,  N = (x₁ − x₀) × (x₂ − x₀),  D² = N·N + (ε E)²     normal of a triangle              (6)
///   ∂r/∂x_q += −∂r/∂v ∂w/∂n ∂n/∂x_q                                                               (7)
///   v·dn = Σ_q ((h × e_q) − 2 (v·N) ε² E/D³ (e_{q+1} − e_{q+2}))·dx_q,  h = v/D − (v·N) N/D³      (8)
/// e_q is the edge opposite to corner q and E the sum of the squares of the edges; with ε = 0.003, n is
/// shorter than 1 by less than 1e-4 unless the triangle is nearly folded to a line. Bars have n = 0.
/// The sums are over the corners of the element. Equation k does not depend on the velocities of the nodes,
/// because the water behind a gear does not follow short motions.
class ChangedWater {
 public:
  /// `base`: the elements; `flow`: the family of the flow.
  ChangedWater(const Scene& scene, const FamilyPlan& plan, const ElementFamily& base,
               const ElementFamily& flow);

  /// The element type for the changed water: the terms of the base that depend on the water, and the unknowns
  /// of the flow.
  const ElementType& type() const { return type_; }
  const ElementFamily& base() const { return base_; }
  /// The node of the unknowns of the flow.
  std::uint32_t node() const;
  int evaluate(const netloft_term& term, netloft_tile& tile) const;
  /// Outputs of the base, in the changed water.
  int output(netloft_tile& tile, double* values) const;

 private:
  struct Normals;
  struct Places;
  struct Tangents;
  bool is_netting() const;
  int find_places(const netloft_tile& tile, Places& places) const;
  void turn_with_netting(const netloft_tile& tile, const Places& places, Tangents& tangents) const;
  void add_forces(const netloft_tile& tile, const Places& places, const double* force) const;
  void add_tangents(const netloft_tile& tile, const Places& places, const Tangents& tangents) const;
  void add_equations(const netloft_tile& tile, const Places& places, const Tangents& tangents,
                     const double* force) const;

  const ElementFamily& base_;
  const ElementFamily& flow_;
  ElementType type_;
  std::size_t corners_, unknowns_;
  std::uint32_t flow_part_ = 0;  // index of the flow's part within its family
  std::vector<double> reach_;    // of each element
};

}  // namespace netloft
