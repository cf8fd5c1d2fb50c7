// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/bodies.hpp"
#include "framework/assembler/tile_evaluator.hpp"

namespace netloft {

/// Passes the forces and matrices of carried nodes, which move with a rigid body, on to this body, by (2) to
/// (4) of bodies.hpp. If (3) or (4) needs forces or matrices that the request does not contain, the elements
/// at carried nodes are evaluated again.
class CarriedNodes {
 public:
  /// `bodies` and `elements` have to outlive this object; `dofs` is the number of all degrees of freedom.
  CarriedNodes(Bodies& bodies, TileEvaluator& elements, TangentChoice tangent, std::size_t dofs)
      : bodies_(bodies), elements_(elements), tangent_(tangent), dofs_(dofs) {}

  /// Passes on the sums of a request, to which all elements at x have been added. Returns false if an element
  /// could not be evaluated: see elements.fault().
  bool pass_on(std::span<const double> x, const Request& request);

 private:
  bool find_rate_matrices(std::span<const double> x, Request request, BodyMatrices& matrices);

  Bodies& bodies_;
  TileEvaluator& elements_;
  TangentChoice tangent_;
  std::size_t dofs_;
  std::vector<double> forces_, damping_, mass_;
};

}  // namespace netloft
