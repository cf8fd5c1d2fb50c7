// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/simd/registers.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace netloft {

/// The nodes of one member (a line that bears tension), or of two members that follow each other (both
/// directions of a triangle of netting). `dof` are the indices of the nodes' coordinates in vectors over all
/// degrees of freedom, 3 per node. `block` are the indices of the 3 x 3 blocks of node pairs in the array of
/// matrix values, row by row, −1 if there is none.
struct MemberSite {
  std::uint32_t first = 0, members = 1, nodes = 2;
  std::array<std::int32_t, 9> dof{}, block{};
};

/// The coefficients c of a member's chord w = Σ c x, and the products of c and the `number` of equal twines
/// that the member represents; one per node (netloft_member).
struct MemberWeights {
  std::array<double, 3> c, number_c;
};

/// All members, by site.
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
  /// Adds the sum over members of n c cᵀ K to the matrix values, with n the number of equal twines.
  void (*add_blocks)(const MemberTable& table, const double* K, double* values);
  /// Does the same with K = a t tᵀ + b I, and adds the sum of n c f t to the forces.
  void (*add_lines)(const MemberTable& table, const double* lines, double* forces, double* values);
};

/// The fastest kernels for this processor.
const MemberKernels& member_kernels();
/// All kernels that this processor can run, the fastest last.
std::vector<MemberKernels> member_kernels_here();

}  // namespace netloft
