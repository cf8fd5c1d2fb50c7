// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/make_factorisation.hpp"

#include "solvers/factorisation/cholmod.hpp"
#include "solvers/factorisation/lower_triangle.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "solvers/factorisation/umfpack.hpp"

namespace netloft {

namespace {

std::unique_ptr<Factorisation> make_spare() {
  if (has_mumps()) return make_mumps_factorisation(MatrixClass::unsymmetric);
  return make_umfpack_factorisation();
}

std::unique_ptr<Factorisation> make(MatrixClass kind, int threads) {
  if (kind == MatrixClass::positive_definite) return make_cholmod_factorisation();
  if (kind == MatrixClass::unsymmetric)
    return make_multifrontal_factorisation(make_spare, OrderingMethod::best, threads);
  if (has_mumps()) return make_mumps_factorisation(kind);
  return make_factorisation_of_lower_triangle(make_umfpack_factorisation());
}

}  // namespace

std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind) { return make(kind, 1); }

MakeFactorisation make_factorisation_with(int threads) {
  return [threads](MatrixClass kind) { return make(kind, threads); };
}

}  // namespace netloft
