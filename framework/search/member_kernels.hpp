// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/simd/registers.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace netloft {

/// The nodes of one member (a line that bears tension), or of two members (the two directions of twines in a
/// triangle of netting). `dof` are the indices of the nodes' coordinates in vectors over all degrees of
/// freedom, 3 per node. `block` are the indices of the 3 x 3 blocks of node pairs in the array of matrix
/// values, row by row; −1 if there is no such block.
struct MemberSite {
  std::uint32_t first = 0, members = 1, nodes = 2;
  std::array<std::int32_t, 9> dof{}, block{};
};

/// For each node of a member: the coefficient c of the node in the chord w = Σ c x, and c times the `number`
/// of equal twines that the member represents (netloft_member).
struct MemberWeights {
  std::array<double, 3> c, number_c;
};

/// All members, grouped by site.
struct MemberTable {
  std::span<const MemberSite> sites;
  std::span<const MemberWeights> weights;
};

/// Calls visit(site, nodes, members) for all sites. Both counts are compile-time constants, so that loops
/// over them unroll.
template <class Visit>
NETLOFT_INLINE void for_sites(const MemberTable& table, const Visit& visit) {
  constexpr std::integral_constant<std::uint32_t, 1> one;
  constexpr std::integral_constant<std::uint32_t, 2> two;
  constexpr std::integral_constant<std::uint32_t, 3> three;
  for (const MemberSite& site : table.sites)
    if (site.nodes == 2)
      site.members == 1 ? visit(site, two, one) : visit(site, two, two);
    else
      site.members == 1 ? visit(site, three, one) : visit(site, three, two);
}

/// Loops over members, compiled for one instruction set. K has 9 numbers per member, row by row and
/// symmetric. `lines` have 6 numbers per member: a unit vector t, a force f, and a, b of K = a t tᵀ + b I
/// (netloft_members).
struct MemberKernels {
  /// Adds (n c cᵀ) ⊗ K of all members to the matrix values; n is the number of equal twines that a member
  /// represents, c are the coefficients of its chord.
  void (*add_blocks)(const MemberTable& table, const double* K, double* values);
  /// Like add_blocks, with K = a t tᵀ + b I; also adds n c f t of all members to the forces.
  void (*add_lines)(const MemberTable& table, const double* lines, double* forces, double* values);
};

/// The fastest kernels for this processor.
const MemberKernels& member_kernels();
/// All kernels that this processor can run, the fastest last.
std::vector<MemberKernels> member_kernels_here();

}  // namespace netloft
