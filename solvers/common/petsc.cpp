// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/common/petsc.hpp"

#include <petscsys.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace netloft::petsc {

void start() {
  PetscBool running = PETSC_FALSE;
  check(PetscInitialized(&running));
  if (running) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  check(PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"));
  check(PetscOptionsSetValue(nullptr, "-skip_petscrc", "true"));
  check(PetscInitializeNoArguments());
  check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr));
  std::atexit([] { PetscFinalize(); });
}

void check(PetscErrorCode code) {
  if (code == PetscErrorCode{}) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw std::runtime_error(std::string("PETSc: ") + (text ? text : "failed"));
}

}  // namespace netloft::petsc
