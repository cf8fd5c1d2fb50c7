// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace netloft {

/// How a thread computes: the direction of rounding, whether subnormal numbers become zero, and which
/// exceptions trap. The flags of past exceptions are not part of the mode, nor is the mode of the x87
/// registers, which double precision does not use. On processors other than x86-64 and AArch64, all modes are
/// equal.
class FloatingPointMode {
 public:
  static FloatingPointMode now() noexcept {
    FloatingPointMode mode;
#if defined(__x86_64__)
    mode.bits_ = _mm_getcsr() & ~kFlags;
#elif defined(__aarch64__)
    asm volatile("mrs %0, fpcr" : "=r"(mode.bits_));
#endif
    return mode;
  }
  void set() const noexcept {
#if defined(__x86_64__)
    _mm_setcsr(bits_ | (_mm_getcsr() & kFlags));
#elif defined(__aarch64__)
    asm volatile("msr fpcr, %0" : : "r"(bits_));
#endif
  }
  bool operator==(const FloatingPointMode&) const = default;

 private:
  static constexpr std::uint32_t kFlags = 0x3f;
#if defined(__aarch64__)
  std::uint64_t bits_ = 0;
#else
  std::uint32_t bits_ = 0;
#endif
};

}  // namespace netloft
