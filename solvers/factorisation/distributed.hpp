// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/problem/factorisation.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/ranks.hpp"

namespace netloft {

/// Factorises by all ranks what has `use.from` unknowns and more, by what `make_on_ranks` makes, else by this
/// process with what `make_local` makes; `analyse` decides. Matrices stay on rank 0, which orders and
/// analyses them; it sends the others what they have to eliminate. The memory that it foresees is that of the
/// rank which takes most. `use.ranks` must not be null, and must outlive it.
std::unique_ptr<Factorisation> make_distributed_factorisation(MatrixClass kind, const RankUse& use,
                                                              MakeFactorisation make_local,
                                                              MakeFactorisation make_on_ranks);

/// By MUMPS on all ranks, whose last bits differ from run to run:
///   positive definite, symmetric   P A Pᵀ = L D Lᵀ   a negative pivot: not positive definite   (1)
///   unsymmetric                    P A Q = L U                                                 (2)
MakeFactorisation make_mumps_on(Ranks& ranks);

/// By our own fronts on all ranks, of which `threads` work on rank 0, with the same bits on any number of
/// ranks:
///   positive definite   P A Pᵀ = L D Lᵀ                                                        (3)
///   unsymmetric         P A Pᵀ = Q L U    `make_spare` makes what it hands over to             (4)
/// Symmetric matrices whose negative pivots are counted are left to what `make_local` makes.
MakeFactorisation make_fronts_on(Ranks& ranks, int threads, MakeSpare make_spare,
                                 MakeFactorisation make_local);

}  // namespace netloft
