// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft {

/// The entries of a sparse matrix that may be non-zero: compressed columns, rows ascending, every diagonal
/// entry present. Symmetric matrices hold the lower triangle only.
struct SparsePattern {
  std::int32_t size = 0;                   // number of unknowns
  std::vector<std::int32_t> column_start;  // size + 1 indices
  std::vector<std::int32_t> row;           // row of each entry
  std::vector<std::int32_t> node;          // unknown -> node, for orderings of the node graph; size long
  bool symmetric = true;
  std::vector<std::int32_t> slot;  // entry -> index of its value; empty: entry k has index k
  std::size_t slots = 0;           // length of the array of values if `slot` is not empty

  std::size_t entries() const { return row.size(); }
  std::size_t slot_of(std::size_t entry) const {
    return slot.empty() ? entry : static_cast<std::size_t>(slot[entry]);
  }
  std::size_t value_slots() const { return slot.empty() ? entries() : slots; }
  bool operator==(const SparsePattern&) const = default;
};

}  // namespace netloft
