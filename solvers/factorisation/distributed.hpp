// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/problem/factorisation.hpp"
#include "solvers/factorisation/ranks.hpp"

namespace netloft {

/// Factorises by MUMPS on all ranks what has `use.from` unknowns and more, else by what `make_local` makes;
/// `analyse` decides. Matrices stay on rank 0, which orders and analyses them; MUMPS sends the others what
/// they have to eliminate.
///   positive definite, symmetric   P A Pᵀ = L D Lᵀ   a negative pivot: not positive definite   (1)
///   unsymmetric                    P A Q = L U                                                 (2)
/// The memory that it foresees is that of the rank which takes most. `use.ranks` must not be null, and must
/// outlive it.
std::unique_ptr<Factorisation> make_distributed_factorisation(MatrixClass kind, const RankUse& use,
                                                              MakeFactorisation make_local);

}  // namespace netloft
