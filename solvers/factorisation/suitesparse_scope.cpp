// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/suitesparse_scope.hpp"

#include <dlfcn.h>

namespace netloft {
namespace {

/// The OpenMP runtime that CHOLMOD uses, if any. It is looked up and not linked, because with -fopenmp this
/// library might get another runtime than CHOLMOD has.
struct OpenMp {
  using GetLevels = int (*)();
  using SetLevels = void (*)(int);
  GetLevels max_active_levels = reinterpret_cast<GetLevels>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  SetLevels set_max_active_levels =
      reinterpret_cast<SetLevels>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));

  bool is_present() const { return max_active_levels != nullptr && set_max_active_levels != nullptr; }
};

const OpenMp& openmp() {
  static const OpenMp runtime;
  return runtime;
}

}  // namespace

SingleThreadScope::SingleThreadScope() {
  if (!openmp().is_present()) return;
  max_active_levels_ = openmp().max_active_levels();
  openmp().set_max_active_levels(0);
}

SingleThreadScope::~SingleThreadScope() {
  if (max_active_levels_ >= 0) openmp().set_max_active_levels(max_active_levels_);
}

CholmodCommon::CholmodCommon(int index) {
  index == CHOLMOD_LONG ? cholmod_l_start(&common_) : cholmod_start(&common_);
  common_.itype = index;
  common_.print = 0;
  common_.error_handler = nullptr;
#if SUITESPARSE_MAIN_VERSION >= 6
  common_.nthreads_max = 1;
#endif
}

CholmodCommon::~CholmodCommon() {
  common_.itype == CHOLMOD_LONG ? cholmod_l_finish(&common_) : cholmod_finish(&common_);
}

}  // namespace netloft
