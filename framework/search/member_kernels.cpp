// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/member_kernels.hpp"

namespace netloft {

namespace {

using wide::Eight, wide::Four, wide::Two;

constexpr double kIdentity[8] = {1, 0, 0, 0, 1, 0, 0, 0};
constexpr std::size_t kBlock = 9, kLine = 6;  // numbers of K and of `lines` per member

/// A 3 x 3 block in registers. It is read through pointers, because clang assumes that a reference returned
/// by a function is aligned.
template <class Register>
struct WideBlock {
  using V = typename Register::V;
  static constexpr int kLanes = Register::kLanes, kParts = 8 / kLanes;
  V part[kParts] = {};
  double last = 0;

  NETLOFT_INLINE void set(const double* K) {
    for (int i = 0; i < kParts; ++i) part[i] = *reinterpret_cast<const V*>(K + kLanes * i);
    last = K[8];
  }
  NETLOFT_INLINE void add(double a, const WideBlock& K) {
    for (int i = 0; i < kParts; ++i) part[i] += a * K.part[i];
    last += a * K.last;
  }
  NETLOFT_INLINE void add_to(double* values) const {
    for (int i = 0; i < kParts; ++i) *reinterpret_cast<V*>(values + kLanes * i) += part[i];
    values[8] += last;
  }
};

/// Sets K = a t tᵀ + b I from a line (t, f, a, b) of a member.
template <class Register>
NETLOFT_INLINE void set_block(const double* line, WideBlock<Register>& K) {
  using Block = WideBlock<Register>;
  using V = typename Register::V;
  const double a = line[4], b = line[5];
  const Four::V t = *reinterpret_cast<const Four::V*>(line);
  const Eight::V ti = __builtin_shufflevector(t, t, 0, 0, 0, 1, 1, 1, 2, 2),
                 tj = __builtin_shufflevector(t, t, 0, 1, 2, 0, 1, 2, 0, 1);
  const auto *rows = reinterpret_cast<const double*>(&ti), *columns = reinterpret_cast<const double*>(&tj);
  for (int i = 0; i < Block::kParts; ++i)
    K.part[i] = a * *reinterpret_cast<const V*>(rows + Block::kLanes * i) *
                    *reinterpret_cast<const V*>(columns + Block::kLanes * i) +
                b * *reinterpret_cast<const V*>(kIdentity + Block::kLanes * i);
  K.last = a * line[2] * line[2] + b;
}

/// Adds the 3 x 3 blocks of all node pairs of a site (the nodes of one or two members). The blocks of (p, q)
/// and (q, p) are equal.
template <class Register, std::uint32_t kNodes, std::uint32_t kMembers>
NETLOFT_INLINE void add_to_pairs(const MemberSite& site, const MemberWeights* weights,
                                 const WideBlock<Register> (&K)[kMembers], double* values) {
  for (std::uint32_t p = 0; p < kNodes; ++p)
    for (std::uint32_t q = 0; q <= p; ++q) {
      WideBlock<Register> sum;
      for (std::uint32_t i = 0; i < kMembers; ++i) sum.add(weights[i].number_c[p] * weights[i].c[q], K[i]);
      const std::int32_t block = site.block[3 * p + q], mirrored = site.block[3 * q + p];
      if (block >= 0) sum.add_to(values + block);
      if (q != p && mirrored >= 0) sum.add_to(values + mirrored);
    }
}

template <std::uint32_t kNodes, std::uint32_t kMembers>
NETLOFT_INLINE void add_to_nodes(const MemberSite& site, const MemberWeights* weights, const double* lines,
                                 double* forces) {
  for (std::uint32_t p = 0; p < kNodes; ++p)
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (std::uint32_t i = 0; i < kMembers; ++i) {
        const double* line = lines + kLine * i;
        sum += weights[i].number_c[p] * (line[3] * line[axis]);
      }
      forces[site.dof[3 * p + axis]] += sum;
    }
}

template <class Register>
NETLOFT_INLINE void add_blocks(const MemberTable& table, const double* K, double* values) {
  const auto add = [&](const MemberSite& site, auto nodes, auto members) NETLOFT_INLINED {
    WideBlock<Register> blocks[members];
    for (std::uint32_t i = 0; i < members; ++i) blocks[i].set(K + kBlock * (site.first + i));
    add_to_pairs<Register, nodes, members>(site, &table.weights[site.first], blocks, values);
  };
  for_sites(table, add);
}

template <class Register>
NETLOFT_INLINE void add_lines(const MemberTable& table, const double* lines, double* forces, double* values) {
  const auto add = [&](const MemberSite& site, auto nodes, auto members) NETLOFT_INLINED {
    const MemberWeights* weights = &table.weights[site.first];
    const double* line = lines + kLine * site.first;
    WideBlock<Register> blocks[members];
    for (std::uint32_t i = 0; i < members; ++i) set_block(line + kLine * i, blocks[i]);
    add_to_pairs<Register, nodes, members>(site, weights, blocks, values);
    add_to_nodes<nodes, members>(site, weights, line, forces);
  };
  for_sites(table, add);
}

#define NETLOFT_KERNELS(name, Register, ...)                                                         \
  struct name {                                                                                      \
    __VA_ARGS__ static void add_blocks(const MemberTable& table, const double* K, double* values) {  \
      netloft::add_blocks<Register>(table, K, values);                                               \
    }                                                                                                \
    __VA_ARGS__ static void add_lines(const MemberTable& table, const double* lines, double* forces, \
                                      double* values) {                                              \
      netloft::add_lines<Register>(table, lines, forces, values);                                    \
    }                                                                                                \
    static constexpr MemberKernels all{add_blocks, add_lines};                                       \
  };

NETLOFT_KERNELS(Plain, Two, )
NETLOFT_KERNELS(Avx2, Four, NETLOFT_AVX2)
NETLOFT_KERNELS(Avx512, Eight, NETLOFT_AVX512)

}  // namespace

std::vector<MemberKernels> member_kernels_here() {
  return wide::those_here(Plain::all, Avx2::all, Avx512::all);
}

const MemberKernels& member_kernels() {
  static const MemberKernels best = member_kernels_here().back();
  return best;
}

}  // namespace netloft
