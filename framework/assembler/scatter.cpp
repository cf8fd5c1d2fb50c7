// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/scatter.hpp"

#include "framework/simd/registers.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace netloft {

namespace {

/// Adds the 3 x 3 blocks of packed lower triangles to the matrix values, for every pair of corners. `Nodes`
/// is a template parameter so that the loops unroll.
template <int Nodes>
void add_lower_blocks(const std::int32_t* map, std::size_t count, const double* __restrict tangent,
                      double* values) {
  for (int P = 0; P < Nodes; ++P)
    for (int Q = 0; Q <= P; ++Q, map += kTileLanes) {
      const double* row[3];
      for (int r = 0; r < 3; ++r)
        row[r] = tangent +
                 (packed(static_cast<std::size_t>(3 * P + r)) + static_cast<std::size_t>(3 * Q)) * kTileLanes;
      for (std::size_t lane = 0; lane < count; ++lane) {
        const bool transposed = map[lane] < 0;
        double* to = values + (transposed ? ~map[lane] : map[lane]);
        const int down = transposed ? 1 : 3, across = transposed ? 3 : 1;
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < (P == Q ? r + 1 : 3); ++c)
            to[r * down + c * across] += row[r][static_cast<std::size_t>(c) * kTileLanes + lane];
      }
    }
}

/// If corners P and Q of an element are the same node (Tiling::Twin), blocks (P, Q) and (Q, P) both belong to
/// the diagonal block of that node. Adds (Q, P), which is the transpose of the stored block (P, Q).
void add_twins(const Tiling& tiling, std::size_t tile, const std::int32_t* map, const double* tangent,
               double* values) {
  for (const auto& twin : tiling.twins[tile]) {
    const auto P = static_cast<std::size_t>(twin.P), Q = static_cast<std::size_t>(twin.Q);
    double* to = values + map[(packed(P) + Q) * kTileLanes + twin.lane];
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        to[3 * r + c] += tangent[(packed(3 * P + c) + 3 * Q + r) * kTileLanes + twin.lane];
  }
}

using Two = wide::Two::V;
using Four = wide::Four::V;

/// The nine entries of a block, row by row, each for all elements (lanes) of a tile. The vector type of each
/// load is written out and registers are passed by value, because a deduced type, or a reference in clang,
/// loses the attribute that permits unaligned access.
struct Entries {
  std::array<const double*, 9> at;
  NETLOFT_INLINE Two two(std::size_t i, std::size_t lane) const {
    return *reinterpret_cast<const Two*>(at[i] + lane);
  }
  NETLOFT_INLINE Four four(std::size_t i, std::size_t lane) const {
    return *reinterpret_cast<const Four*>(at[i] + lane);
  }
  NETLOFT_INLINE double one(std::size_t i, std::size_t lane) const { return at[i][lane]; }
};

struct BothEntries {
  Entries a, b;
  NETLOFT_INLINE Two two(std::size_t i, std::size_t lane) const { return a.two(i, lane) + b.two(i, lane); }
  NETLOFT_INLINE Four four(std::size_t i, std::size_t lane) const {
    return a.four(i, lane) + b.four(i, lane);
  }
  NETLOFT_INLINE double one(std::size_t i, std::size_t lane) const { return a.one(i, lane) + b.one(i, lane); }
};

template <int Nodes>
NETLOFT_INLINE Entries square_entries(const double* square, int P, int Q) {
  Entries entries;
  for (std::size_t i = 0; i < 9; ++i)
    entries.at[i] = square + ((3 * static_cast<std::size_t>(P) + i / 3) * 3 * Nodes +
                              3 * static_cast<std::size_t>(Q) + i % 3) *
                                 kTileLanes;
  return entries;
}

NETLOFT_INLINE Entries packed_entries(const double* packed_tangent, int P, int Q) {
  Entries entries;
  for (std::size_t i = 0; i < 9; ++i) {
    const std::size_t row = 3 * static_cast<std::size_t>(P) + i / 3,
                      column = 3 * static_cast<std::size_t>(Q) + i % 3;
    entries.at[i] = packed_tangent + (packed(std::max(row, column)) + std::min(row, column)) * kTileLanes;
  }
  return entries;
}

/// values[to + i] += entry i of an element's block, for the elements `lane` and `lane` + 1. At first, a
/// register holds one entry of both elements; after a transposition, it holds two entries of one element.
template <class EntriesOfLanes>
NETLOFT_INLINE void add_two_lanes(const std::int32_t* to, const EntriesOfLanes& entries, std::size_t lane,
                                  double* values) {
  double *first = values + to[lane], *second = values + to[lane + 1];
  Two a, b;
  for (std::size_t i = 0; i < 8; i += 2) {
    a = entries.two(i, lane);
    b = entries.two(i + 1, lane);
    *reinterpret_cast<Two*>(first + i) += Two{a[0], b[0]};
    *reinterpret_cast<Two*>(second + i) += Two{a[1], b[1]};
  }
  a = entries.two(8, lane);
  first[8] += a[0];
  second[8] += a[1];
}

/// The same as add_two_lanes, for four elements.
template <class EntriesOfLanes>
NETLOFT_INLINE void add_four_lanes(const std::int32_t* to, const EntriesOfLanes& entries, std::size_t lane,
                                   double* values) {
  Four v[4];
  for (std::size_t i = 0; i < 8; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) v[k] = entries.four(i + k, lane);
    const Four even = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6),
               odd = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
               even_below = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6),
               odd_below = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
    double* at = values + i;
    *reinterpret_cast<Four*>(at + to[lane]) += __builtin_shufflevector(even, even_below, 0, 1, 4, 5);
    *reinterpret_cast<Four*>(at + to[lane + 1]) += __builtin_shufflevector(odd, odd_below, 0, 1, 4, 5);
    *reinterpret_cast<Four*>(at + to[lane + 2]) += __builtin_shufflevector(even, even_below, 2, 3, 6, 7);
    *reinterpret_cast<Four*>(at + to[lane + 3]) += __builtin_shufflevector(odd, odd_below, 2, 3, 6, 7);
  }
  v[0] = entries.four(8, lane);
  for (std::size_t k = 0; k < 4; ++k) values[to[lane + k] + 8] += v[0][k];
}

/// Adds the 3 x 3 blocks of one pair of corners of all elements of a tile.
template <bool kWide, class EntriesOfLanes>
NETLOFT_INLINE void add_pair(const std::int32_t* to, std::size_t count, const EntriesOfLanes& entries,
                             double* values) {
  std::size_t lane = 0;
  if constexpr (kWide)
    for (; lane + 4 <= count; lane += 4) add_four_lanes(to, entries, lane, values);
  for (; lane + 2 <= count; lane += 2) add_two_lanes(to, entries, lane, values);
  if (lane < count)
    for (std::size_t i = 0; i < 9; ++i)
      values[to[lane] + static_cast<std::ptrdiff_t>(i)] += entries.one(i, lane);
}

/// Tangents of all elements of a tile; nullptr if there are none.
struct Tangents {
  const double *triangle, *square;
};

/// Adds the 3 x 3 blocks of all pairs of corners.
template <bool kWide, int Nodes>
NETLOFT_INLINE void add_blocks(const std::int32_t* to, std::size_t count, const Tangents& t, double* values) {
  for (int P = 0; P < Nodes; ++P)
    for (int Q = 0; Q < Nodes; ++Q, to += kTileLanes)
      if (!t.triangle)
        add_pair<kWide>(to, count, square_entries<Nodes>(t.square, P, Q), values);
      else if (!t.square)
        add_pair<kWide>(to, count, packed_entries(t.triangle, P, Q), values);
      else
        add_pair<kWide>(to, count,
                        BothEntries{square_entries<Nodes>(t.square, P, Q), packed_entries(t.triangle, P, Q)},
                        values);
}

template <bool kWide>
NETLOFT_INLINE void add_all_blocks(std::size_t dofs, const std::int32_t* to, std::size_t count,
                                   const Tangents& tangents, double* values) {
  switch (dofs) {
    case 3:
      return add_blocks<kWide, 1>(to, count, tangents, values);
    case 6:
      return add_blocks<kWide, 2>(to, count, tangents, values);
    case 9:
      return add_blocks<kWide, 3>(to, count, tangents, values);
    default:
      return add_blocks<kWide, 4>(to, count, tangents, values);
  }
}

using AddBlocks = void (*)(std::size_t dofs, const std::int32_t* to, std::size_t count,
                           const Tangents& tangents, double* values);

void add_blocks_plainly(std::size_t dofs, const std::int32_t* to, std::size_t count, const Tangents& tangents,
                        double* values) {
  add_all_blocks<false>(dofs, to, count, tangents, values);
}

NETLOFT_AVX2 void add_blocks_widely(std::size_t dofs, const std::int32_t* to, std::size_t count,
                                    const Tangents& tangents, double* values) {
  add_all_blocks<true>(dofs, to, count, tangents, values);
}

/// Returns the fastest kernel for this processor. All kernels give bit-identical results.
AddBlocks best_way_to_add_blocks() {
  return wide::those_here<AddBlocks>(add_blocks_plainly, add_blocks_widely, add_blocks_widely).back();
}

/// Calls add(number of nodes of an element) with the number as a compile-time constant.
template <class Add>
void with_nodes(std::size_t dofs, const Add& add) {
  switch (dofs) {
    case 3:
      return add(std::integral_constant<int, 1>{});
    case 6:
      return add(std::integral_constant<int, 2>{});
    case 9:
      return add(std::integral_constant<int, 3>{});
    default:
      return add(std::integral_constant<int, 4>{});
  }
}

/// Divides the moments of elements on bodies by the arms of the bodies, and also the rows and columns of
/// rotations in their tangents, because the unknowns of rotations are lengths.
void divide_moments(const Tiling& tiling, std::size_t tile, double* force, double* triangle, double* square) {
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  std::array<double, kTileLanes> inverse;
  for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane)
    inverse[lane] = 1 / tiling.family->arm(tile * kTileLanes + lane);
  const auto is_turn = [](std::size_t d) { return d / 3 == 1; };
  const auto divide = [&](double* row) {
    for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane) row[lane] *= inverse[lane];
  };
  for (std::size_t r = 0; r < dofs; ++r) {
    if (force && is_turn(r)) divide(force + r * kTileLanes);
    for (std::size_t c = 0; c < dofs; ++c)
      for (int times = is_turn(r) + is_turn(c); times > 0; --times) {
        if (square) divide(square + (r * dofs + c) * kTileLanes);
        if (triangle && c <= r) divide(triangle + (packed(r) + c) * kTileLanes);
      }
  }
}

void add_rows(const Tiling& tiling, std::size_t tile, const double* rows, double* sums) {
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  const std::size_t count = tiling.lanes(tile);
  const std::int32_t* map = &tiling.vector_map[tile * dofs * kTileLanes];
  for (std::size_t d = 0; d < dofs; ++d)
    for (std::size_t lane = 0; lane < count; ++lane)
      sums[map[d * kTileLanes + lane]] += rows[d * kTileLanes + lane];
}

/// Skips tiles whose tangents are zero, of which there are many, for instance in netting without bending
/// stiffness.
void scatter_matrix(const Tiling& tiling, std::size_t tile, bool is_symmetric, double* values,
                    TileSums& sums) {
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  const std::size_t count = tiling.lanes(tile);
  const std::int32_t* map = &tiling.block_map[tile * tiling.blocks_per_element * kTileLanes];
  const double *triangle = sums.packed_tangent.data(), *square = sums.square_tangent.data();
  const bool symmetric = !sums.packed_tangent.is_zero(), unsymmetric = !sums.square_tangent.is_zero();
  if (is_symmetric) {
    if (!symmetric) return;
    add_twins(tiling, tile, map, triangle, values);
    with_nodes(dofs, [&](auto nodes) { add_lower_blocks<nodes>(map, count, triangle, values); });
  } else if (symmetric || unsymmetric) {
    static const AddBlocks add = best_way_to_add_blocks();
    add(dofs, map, count, {symmetric ? triangle : nullptr, unsymmetric ? square : nullptr}, values);
  }
}

}  // namespace

void scatter_gradient(const Tiling& tiling, std::size_t tile, TileSums& sums, double* gradient) {
  if (!sums.force.is_open()) return;
  const double* rows = sums.force.data();
  if (tiling.family->type().is_on_body()) {
    std::copy_n(rows, static_cast<std::size_t>(tiling.family->type().dofs()) * kTileLanes,
                sums.scratch.data());
    divide_moments(tiling, tile, sums.scratch.data(), nullptr, nullptr);
    rows = sums.scratch.data();
  }
  add_rows(tiling, tile, rows, gradient);
}

void scatter(const Tiling& tiling, std::size_t tile, bool is_symmetric, TileSums& sums, double* residual,
             double* values) {
  if (tiling.family->type().is_on_body())
    divide_moments(tiling, tile, residual && !sums.force.is_zero() ? sums.force.data() : nullptr,
                   values && !sums.packed_tangent.is_zero() ? sums.packed_tangent.data() : nullptr,
                   values && !sums.square_tangent.is_zero() ? sums.square_tangent.data() : nullptr);
  if (residual && !sums.force.is_zero()) add_rows(tiling, tile, sums.force.data(), residual);
  if (values) scatter_matrix(tiling, tile, is_symmetric, values, sums);
}

}  // namespace netloft
