// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/make_factorisation.hpp"

#include "solvers/factorisation/lower_triangle.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/mumps.hpp"

namespace netloft {

namespace {

std::unique_ptr<Factorisation> make_unsymmetric(int threads) {
  MakeSpare spare;
  if (has_mumps()) spare = [] { return make_mumps_factorisation(MatrixClass::unsymmetric); };
  return make_multifrontal_factorisation(std::move(spare), OrderingMethod::best, threads);
}

std::unique_ptr<Factorisation> make(MatrixClass kind, int threads) {
  if (kind == MatrixClass::positive_definite)
    return make_definite_factorisation(OrderingMethod::best, threads);
  if (kind == MatrixClass::unsymmetric) return make_unsymmetric(threads);
  if (has_mumps()) return make_mumps_factorisation(kind);
  return make_factorisation_of_lower_triangle(make_unsymmetric(threads));
}

}  // namespace

std::unique_ptr<Factorisation> make_factorisation(MatrixClass kind) { return make(kind, 1); }

MakeFactorisation make_factorisation_with(int threads) {
  return [threads](MatrixClass kind) { return make(kind, threads); };
}

}  // namespace netloft
