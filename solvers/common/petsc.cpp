// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/common/petsc.hpp"

#include <petscsys.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace netloft::petsc {

namespace {

/// In a run on several ranks MPI has been started, and the other ranks know nothing of PETSc.
void use_this_process_alone() {
  int is_running = 0;
  MPI_Initialized(&is_running);
  if (is_running) PETSC_COMM_WORLD = MPI_COMM_SELF;
}

}  // namespace

void start() {
  PetscBool running = PETSC_FALSE;
  check(PetscInitialized(&running));
  if (running) return;
  use_this_process_alone();
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
