// SPDX-License-Identifier: BSD-3-Clause
// Replaces mumps.cpp in builds without MUMPS.
#include <stdexcept>

#include "solvers/factorisation/mumps.hpp"

namespace netloft {

bool has_mumps() { return false; }

std::unique_ptr<Factorisation> make_mumps_factorisation(MatrixClass, OrderingMethod) {
  throw std::logic_error("built without MUMPS");
}

std::unique_ptr<Factorisation> make_mumps_factorisation_on(Ranks&, MatrixClass, OrderingMethod) {
  throw std::logic_error("built without MUMPS");
}

bool fits_mumps(std::string_view, std::size_t) { return false; }

}  // namespace netloft
