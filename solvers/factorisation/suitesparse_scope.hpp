// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cholmod.h>

namespace netloft {

/// While this object lives, calls into SuiteSparse stay in the calling thread.
///
/// CHOLMOD 3 is compiled for four OpenMP threads and opens a parallel region in each of some 10⁴ supernodes;
/// OMP_NUM_THREADS does not change that. On a busy machine the threads spin while they wait for each other
/// and slow a factorisation down by up to a factor of 70. On a quiet machine they take 2.5 times the CPU time
/// without any gain on nets.
class SingleThreadScope {
 public:
  SingleThreadScope();
  SingleThreadScope(const SingleThreadScope&) = delete;
  SingleThreadScope& operator=(const SingleThreadScope&) = delete;
  ~SingleThreadScope();
  /// Whether a scope is open in this thread.
  static bool is_open();

 private:
  int max_active_levels_ = -1;
};

/// CHOLMOD's parameters and workspace, without printing. `index` must be CHOLMOD_INT for the functions of
/// CHOLMOD with 32-bit indices and CHOLMOD_LONG for those with 64 bits.
class CholmodCommon {
 public:
  explicit CholmodCommon(int index = CHOLMOD_INT);
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;
  ~CholmodCommon();

  cholmod_common* operator->() { return &common_; }
  const cholmod_common* operator->() const { return &common_; }
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_;
};

}  // namespace netloft
