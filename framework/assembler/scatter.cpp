// SPDX-License-Identifier: BSD-3-Clause
//
// What the elements of a tile give, added where it belongs.
#include "framework/assembler/workspace.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace netloft {

namespace {

/// Adds the blocks of a packed lower triangle, corner by corner. `Nodes` is known so that the loops unroll.
template <int Nodes>
void add_lower_blocks(const std::int32_t* map, std::size_t count, const double* __restrict tangent,
                      double* values) {
  for (int P = 0; P < Nodes; ++P)
    for (int Q = 0; Q <= P; ++Q, map += kLanes) {
      const double* row[3];
      for (int r = 0; r < 3; ++r)
        row[r] = tangent +
                 (packed(static_cast<std::size_t>(3 * P + r)) + static_cast<std::size_t>(3 * Q)) * kLanes;
      for (std::size_t lane = 0; lane < count; ++lane) {
        const bool transposed = map[lane] < 0;
        double* to = values + (transposed ? ~map[lane] : map[lane]);
        const int down = transposed ? 1 : 3, across = transposed ? 3 : 1;
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < (P == Q ? r + 1 : 3); ++c)
            to[r * down + c * across] += row[r][static_cast<std::size_t>(c) * kLanes + lane];
      }
    }
}

/// Adds the transpose of every block that stands on the diagonal for two.
void add_twins(const Tiling& tiling, std::size_t tile, const std::int32_t* map, const double* tangent,
               double* values) {
  for (const auto& twin : tiling.twins[tile]) {
    const auto P = static_cast<std::size_t>(twin.P), Q = static_cast<std::size_t>(twin.Q);
    double* to = values + map[(packed(P) + Q) * kLanes + twin.lane];
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        to[3 * r + c] += tangent[(packed(3 * P + c) + 3 * Q + r) * kLanes + twin.lane];
  }
}

/// Two numbers in a register, anywhere in memory.
typedef double Two __attribute__((vector_size(16), aligned(8), may_alias));

/// The nine entries of a block, row by row, each in all lanes.
struct Entries {
  std::array<const double*, 9> at;
  Two pair(std::size_t i, std::size_t lane) const { return *reinterpret_cast<const Two*>(at[i] + lane); }
  double one(std::size_t i, std::size_t lane) const { return at[i][lane]; }
};

/// The sum of two.
struct BothEntries {
  Entries a, b;
  Two pair(std::size_t i, std::size_t lane) const { return a.pair(i, lane) + b.pair(i, lane); }
  double one(std::size_t i, std::size_t lane) const { return a.one(i, lane) + b.one(i, lane); }
};

template <int Nodes>
Entries square_entries(const double* square, int P, int Q) {
  Entries entries;
  for (std::size_t i = 0; i < 9; ++i)
    entries.at[i] = square + ((3 * static_cast<std::size_t>(P) + i / 3) * 3 * Nodes +
                              3 * static_cast<std::size_t>(Q) + i % 3) *
                                 kLanes;
  return entries;
}

Entries packed_entries(const double* packed_tangent, int P, int Q) {
  Entries entries;
  for (std::size_t i = 0; i < 9; ++i) {
    const std::size_t row = 3 * static_cast<std::size_t>(P) + i / 3,
                      column = 3 * static_cast<std::size_t>(Q) + i % 3;
    entries.at[i] = packed_tangent + (packed(std::max(row, column)) + std::min(row, column)) * kLanes;
  }
  return entries;
}

/// values[to + i] += entry i of a lane, for two lanes, whose entries become neighbours in the registers.
template <class Pair>
void add_two_lanes(double* first, double* second, const Pair& pair) {
  for (std::size_t i = 0; i < 8; i += 2) {
    const Two a = pair(i), b = pair(i + 1);
    *reinterpret_cast<Two*>(first + i) += Two{a[0], b[0]};
    *reinterpret_cast<Two*>(second + i) += Two{a[1], b[1]};
  }
  const Two last = pair(8);
  first[8] += last[0], second[8] += last[1];
}

/// Adds the blocks of all pairs of corners; entries_of(P, Q) has pair(i) and one(i), entry i of two lanes and
/// of one.
template <int Nodes, class EntriesOf>
void add_blocks(const std::int32_t* map, std::size_t count, const EntriesOf& entries_of, double* values) {
  for (int P = 0; P < Nodes; ++P)
    for (int Q = 0; Q < Nodes; ++Q, map += kLanes) {
      const auto entry = entries_of(P, Q);
      std::size_t lane = 0;
      for (; lane + 2 <= count; lane += 2)
        add_two_lanes(values + map[lane], values + map[lane + 1],
                      [&](std::size_t i) { return entry.pair(i, lane); });
      if (lane < count)
        for (std::size_t i = 0; i < 9; ++i)
          values[map[lane] + static_cast<std::ptrdiff_t>(i)] += entry.one(i, lane);
    }
}

/// Calls add(nodes of an element), known at compile time.
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

}  // namespace

void Assembler::scatter(const Company& company, std::size_t tile, const Request& request, Workspace& w) {
  const Tiling& tiling = company.tiling;
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  const std::size_t count = tiling.lanes(tile);
  if (request.energy) {
    double sum = 0;
    for (std::size_t lane = 0; lane < count; ++lane) sum += w.energy[lane];
    tile_energy_[company.first_tile + tile] = sum;
  }
  if (request.residual && !w.force.is_zero()) {
    const std::int32_t* map = &tiling.vector_map[tile * dofs * kLanes];
    const double* force = w.force.data();
    for (std::size_t d = 0; d < dofs; ++d)
      for (std::size_t lane = 0; lane < count; ++lane)
        request.residual[map[d * kLanes + lane]] += force[d * kLanes + lane];
  }
  if (request.values) scatter_matrix(tiling, tile, request.values, w);
}

/// Many a tile adds nothing: netting without bending, limits that nothing has reached.
void Assembler::scatter_matrix(const Tiling& tiling, std::size_t tile, double* values, Workspace& w) {
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  const std::size_t count = tiling.lanes(tile);
  const std::int32_t* map = &tiling.block_map[tile * tiling.blocks_per_element * kLanes];
  const double *triangle = w.packed_tangent.data(), *square = w.square_tangent.data();
  const bool symmetric = !w.packed_tangent.is_zero(), unsymmetric = !w.square_tangent.is_zero();
  if (pattern_.symmetric) {
    if (!symmetric) return;
    add_twins(tiling, tile, map, triangle, values);
    with_nodes(dofs, [&](auto nodes) { add_lower_blocks<nodes>(map, count, triangle, values); });
  } else if (symmetric && unsymmetric) {
    with_nodes(dofs, [&](auto nodes) {
      const auto entries = [&](int P, int Q) {
        return BothEntries{square_entries<nodes>(square, P, Q), packed_entries(triangle, P, Q)};
      };
      add_blocks<nodes>(map, count, entries, values);
    });
  } else if (symmetric) {
    const auto entries = [&](int P, int Q) { return packed_entries(triangle, P, Q); };
    with_nodes(dofs, [&](auto nodes) { add_blocks<nodes>(map, count, entries, values); });
  } else if (unsymmetric) {
    with_nodes(dofs, [&](auto nodes) {
      const auto entries = [&](int P, int Q) { return square_entries<nodes>(square, P, Q); };
      add_blocks<nodes>(map, count, entries, values);
    });
  }
}

}  // namespace netloft
