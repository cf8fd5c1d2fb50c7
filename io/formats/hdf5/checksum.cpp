// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/checksum.hpp"

#include <zlib.h>

#include <cstring>

namespace netloft::formats {
namespace {

std::uint32_t by_zlib(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

#if defined(__x86_64__)

/// x^n mod P, P the polynomial of CRC-32, bits reflected as in the checksum: x^0 is the highest bit.
constexpr std::uint32_t power_of_x(int n) {
  std::uint32_t r = 0x80000000;
  for (; n > 0; --n) r = (r >> 1) ^ (r & 1 ? 0xedb88320 : 0);
  return r;
}

/// Factors that move a block of 128 bits `bits` further to the end of the message. With a block
/// B = L x^64 + H, the first eight bytes being L, and P as above,
///   B x^bits = L (x^(bits + 64) mod P) + H (x^bits mod P)   (mod P)                       (1)
/// A product of reflected numbers of 64 bits lies one bit too low, and a factor of 32 bits in the lower half
/// 32 bits too high; exponents are smaller by 32, and factors are shifted by one for it. (V. Gopal et al.,
/// "Fast CRC Computation for Generic Polynomials Using PCLMULQDQ Instruction", Intel 323102, 2009.)
struct Move {
  std::uint64_t first, second;
  constexpr explicit Move(int bits)
      : first(std::uint64_t{power_of_x(bits + 32)} << 1), second(std::uint64_t{power_of_x(bits - 32)} << 1) {}
};

constexpr Move kByFour{512}, kByOne{128};

/// 128 bits of the message, the first eight bytes in front.
typedef long long Block __attribute__((vector_size(16)));

Block block_at(const char* at) {
  Block block;
  std::memcpy(&block, at, sizeof block);
  return block;
}
Block factors_of(const Move& move) {
  return Block{static_cast<long long>(move.first), static_cast<long long>(move.second)};
}

#define NETLOFT_CARRYLESS [[gnu::target("pclmul,sse4.1")]]

/// (1), and what stands there added.
NETLOFT_CARRYLESS inline Block move_onto(Block block, Block move, Block there) {
  return there ^ __builtin_ia32_pclmulqdq128(block, move, 0x00) ^
         __builtin_ia32_pclmulqdq128(block, move, 0x11);
}

/// Four blocks side by side, so that no product waits for the one before; then all in one block that has the
/// remainder of the whole, whose checksum zlib finds. At least four blocks.
NETLOFT_CARRYLESS std::uint32_t by_products(std::string_view bytes, std::uint32_t before) {
  constexpr std::size_t kSize = sizeof(Block);
  const char* at = bytes.data();
  const char* const end = at + bytes.size();
  Block a = block_at(at) ^ Block { ~before, 0 }, b = block_at(at + kSize), c = block_at(at + 2 * kSize),
        d = block_at(at + 3 * kSize);
  const Block by_four = factors_of(kByFour), by_one = factors_of(kByOne);
  for (at += 4 * kSize; end - at >= static_cast<std::ptrdiff_t>(4 * kSize); at += 4 * kSize) {
    a = move_onto(a, by_four, block_at(at));
    b = move_onto(b, by_four, block_at(at + kSize));
    c = move_onto(c, by_four, block_at(at + 2 * kSize));
    d = move_onto(d, by_four, block_at(at + 3 * kSize));
  }
  a = move_onto(move_onto(move_onto(a, by_one, b), by_one, c), by_one, d);
  char rest[kSize];
  std::memcpy(rest, &a, kSize);
  const std::uint32_t sum = by_zlib({rest, kSize}, ~0U);  // zlib inverts what it begins with
  return by_zlib({at, static_cast<std::size_t>(end - at)}, sum);
}

bool multiplies_polynomials() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("sse4.1");
}

#endif

}  // namespace

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
#if defined(__x86_64__)
  static const bool has_products = multiplies_polynomials();
  if (has_products && bytes.size() >= 4 * sizeof(Block)) return by_products(bytes, before);
#endif
  return by_zlib(bytes, before);
}

}  // namespace netloft::formats
