// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"
#include "framework/assembler/numbering.hpp"
#include "framework/problem/factorisation.hpp"

#include <memory>
#include <span>

namespace netloft {

/// The non-zeros that the elements of all families can make, lower triangle if symmetric.
SparsePattern make_pattern(std::span<const std::unique_ptr<Family>> families, const Numbering& numbering,
                           std::size_t nodes, bool symmetric);

/// Place of (row, column) in the pattern's entries; it must be there.
std::size_t find_entry(const SparsePattern& pattern, std::int32_t row, std::int32_t column);

}  // namespace netloft
