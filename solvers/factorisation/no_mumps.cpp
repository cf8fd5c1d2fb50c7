// SPDX-License-Identifier: BSD-3-Clause
// Replaces mumps.cpp in builds without MUMPS.
#include <stdexcept>

#include "solvers/factorisation/mumps.hpp"

namespace netloft {

bool has_mumps() { return false; }

std::unique_ptr<Factorisation> make_mumps_factorisation(MatrixClass, OrderingMethod) {
  throw std::logic_error("built without MUMPS");
}

}  // namespace netloft
