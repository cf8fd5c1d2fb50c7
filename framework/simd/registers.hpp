// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

// Macros for loops that are compiled once for each instruction set. Functions that such a loop calls must be
// inlined, so that they are compiled for the same instruction set. Registers are passed as `Register::V`,
// never as a deduced type, because deduced types lose the attribute for unaligned access.
#define NETLOFT_INLINE [[gnu::always_inline]] inline
#define NETLOFT_INLINED __attribute__((always_inline))  // the attribute for lambdas

#if defined(__x86_64__)
#define NETLOFT_AVX2 [[gnu::target("avx2,fma")]]
#define NETLOFT_AVX512 [[gnu::target("avx512f,avx512dq,avx512vl,avx2,fma")]]
#else
#define NETLOFT_AVX2
#define NETLOFT_AVX512
#endif

namespace netloft::wide {

/// Vectors as wide as one register. They need not be aligned.
struct Two {
  typedef double V __attribute__((vector_size(16), aligned(8), may_alias));
  static constexpr int kLanes = 2;
};
struct Four {
  typedef double V __attribute__((vector_size(32), aligned(8), may_alias));
  static constexpr int kLanes = 4;
};
struct Eight {
  typedef double V __attribute__((vector_size(64), aligned(8), may_alias));
  static constexpr int kLanes = 8;
};

/// Sums of all lanes, formed in pairs so that additions do not wait for each other.
NETLOFT_INLINE double sum_of(const Two::V& v) { return v[0] + v[1]; }
NETLOFT_INLINE double sum_of(const Four::V& v) {
  return sum_of(__builtin_shufflevector(v, v, 0, 1) + __builtin_shufflevector(v, v, 2, 3));
}
NETLOFT_INLINE double sum_of(const Eight::V& v) {
  return sum_of(__builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7));
}

/// Returns the kernels whose instruction sets this processor has, the fastest last.
template <class Kernels>
std::vector<Kernels> those_here(const Kernels& plain, [[maybe_unused]] const Kernels& avx2,
                                [[maybe_unused]] const Kernels& avx512) {
  std::vector<Kernels> here{plain};
#if defined(__x86_64__)
  __builtin_cpu_init();
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (has_avx2) here.push_back(avx2);
  if (has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    here.push_back(avx512);
#endif
  return here;
}

}  // namespace netloft::wide
