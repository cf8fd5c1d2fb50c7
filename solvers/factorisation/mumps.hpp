// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

/// Whether this program was built with MUMPS.
bool has_mumps();

/// Multifrontal factorisation by MUMPS, with threshold pivoting, of matrices that are not positive definite.
///   P A Pᵀ = L D Lᵀ   symmetric: D has blocks of 1×1 and 2×2; P orders the nodes and delays pivots     (1)
///   P A Q  = L U      unsymmetric: the pattern should be nearly symmetric                              (2)
/// For symmetric matrices, the negative eigenvalues of D are counted; A has the same number (Sylvester's law
/// of inertia). From the second `factorise` on, neither `factorise` nor `solve` allocates. A pivot below 1e-5
/// eps ‖A‖ is reported as singular at its unknown; larger pivots pass even if they are only round-off.
/// Because MUMPS has global variables, calls from several threads wait for each other. `kind` must not be
/// positive_definite.
std::unique_ptr<Factorisation> make_mumps_factorisation(MatrixClass kind,
                                                        OrderingMethod method = OrderingMethod::best);

}  // namespace netloft
