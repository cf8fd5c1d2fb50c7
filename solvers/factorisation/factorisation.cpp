// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/factorisation.hpp"

#include "solvers/factorisation/cholmod.hpp"
#include "solvers/factorisation/umfpack.hpp"

namespace netloft {

std::unique_ptr<Factorisation> make_factorisation(bool symmetric) {
  return symmetric ? make_cholmod_factorisation() : make_umfpack_factorisation();
}

}  // namespace netloft
