// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/factorisation.hpp"

#include "solvers/factorisation/cholmod.hpp"
#include "solvers/factorisation/lower_triangle.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "solvers/factorisation/umfpack.hpp"

namespace netloft {

std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind) {
  if (kind == MatrixClass::positive_definite) return make_cholmod_factorisation();
  if (has_mumps()) return make_mumps_factorisation(kind);
  auto umfpack = make_umfpack_factorisation();
  return kind == MatrixClass::unsymmetric ? std::move(umfpack)
                                          : make_factorisation_of_lower_triangle(std::move(umfpack));
}

}  // namespace netloft
