// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace netloft::io {

/// Nodes that members stand on, one, or both directions of a triangle, one after the other: where the nodes
/// stand, 3 each, and the blocks of their pairs, row by row, among the values; -1: none.
struct MemberSite {
  std::uint32_t first = 0, members = 1, nodes = 2;
  std::array<std::int32_t, 9> dof{}, block{};
};

/// A member's share in what its nodes do: c, and n c; 1/l₀ [1/m].
struct MemberWeights {
  std::array<double, 3> c, count_c;
  double inverse_l0;
};

/// A member at the positions of now: its direction, 1/length [1/m], w and length [m], strain [1]; no numbers
/// where w is zero.
struct MemberLine {
  std::array<double, 3> t;
  double inverse;
  std::array<double, 3> w;
  double l, strain;
};

/// Row by row, of a member.
using MemberBlock = std::array<double, 9>;

/// What a member does in its line: f t [N], and K = a t tᵀ + b I [N/m].
struct MemberTangent {
  double f, a, b;
};

/// Members as their sites have them.
struct MemberTable {
  std::span<const MemberSite> sites;
  std::span<const MemberWeights> weights;
};

/// Loops over members for the instructions this processor has.
struct MemberKernels {
  /// values ← values + Σ n c cᵀ K, K symmetric.
  void (*add_blocks)(const MemberTable& table, const MemberBlock* K, double* values);
  /// The same, and forces ← forces + Σ n c f t.
  void (*add_tangents)(const MemberTable& table, const MemberLine* lines, const MemberTangent* tangents,
                       double* forces, double* values);
};

/// The best there is, and all that run here, the best last.
const MemberKernels& member_kernels();
std::vector<MemberKernels> member_kernels_here();

}  // namespace netloft::io
