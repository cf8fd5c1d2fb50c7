// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/suitesparse_scope.hpp"

#include <dlfcn.h>

namespace netloft {
namespace {

/// The OpenMP runtime that CHOLMOD uses, if any. It is looked up at run time, because linking with -fopenmp
/// might give this library another runtime than CHOLMOD has.
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

thread_local int scopes_here = 0;  // open scopes of this thread

}  // namespace

SingleThreadScope::SingleThreadScope() {
  ++scopes_here;
  if (!openmp().is_present()) return;
  max_active_levels_ = openmp().max_active_levels();
  openmp().set_max_active_levels(0);
}

bool SingleThreadScope::is_open() { return scopes_here > 0; }

SingleThreadScope::~SingleThreadScope() {
  --scopes_here;
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

namespace {

using Region = void (*)(void*);
using Parallel = void (*)(Region, void*, unsigned threads, unsigned flags);

}  // namespace

/// Starts a parallel region of CHOLMOD, in place of the function of GCC's OpenMP runtime. Within a scope, the
/// region is a plain call. The runtime would make a team of one thread and signal waiting threads, although
/// there are none, by a system call; a factorisation of 1 300 unknowns has some 500 regions.
extern "C" [[gnu::visibility("default")]] void GOMP_parallel(Region region, void* data, unsigned threads,
                                                             unsigned flags);

void GOMP_parallel(Region region, void* data, unsigned threads, unsigned flags) {
  static const auto runtime = reinterpret_cast<Parallel>(dlsym(RTLD_NEXT, "GOMP_parallel"));
  if (netloft::SingleThreadScope::is_open() || runtime == nullptr) return region(data);
  runtime(region, data, threads, flags);
}
