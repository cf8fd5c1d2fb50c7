// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/ranks/messages.hpp"

#include <string>
#include <vector>

namespace netloft {

/// What rank 0 has the others do with a scene.
enum class ShareJob : int { open, join, evaluate, set_memory, close };

/// How a scene becomes an assembler: a scene may have changed since its plan was made, so what the plan says
/// of terms goes along. As many bytes of terms and of the scene follow.
struct ShareOpening {
  std::uint64_t terms = 0, bytes = 0;
  TangentChoice tangent = TangentChoice::exact;
  bool symmetric = true, conservative = true;
};

/// Calls visit(term) for all terms of all families, in the order of the plan.
template <class PlanLike, class Visit>
void visit_terms(PlanLike& plan, const Visit& visit) {
  for (auto& family : plan.families)
    for (auto& term : family.terms) visit(term);
}
enum TermUse : std::uint8_t { kTermIsOn = 1, kTermWhenItMoves = 2 };

/// What the assemblers of all ranks must have in common, and how long a sentence follows that says why one
/// could not be made.
struct ShareSizes {
  std::uint64_t dofs = 0, slots = 0, tiles = 0, remembered = 0, sentence = 0;
  bool operator==(const ShareSizes&) const = default;
};
inline ShareSizes sizes_of(const Assembler& assembler) {
  return {assembler.numbering().dofs(), assembler.value_slots(), assembler.tile_energies().size(),
          assembler.memory().size()};
}

inline bool wants_matrix(const Request& request) {
  return request.values && request.matrix != MatrixKind::none;
}

/// What is asked of an evaluation. Positions follow, and what they round off if it is known.
struct ShareRequest {
  bool energy = false, residual = false, gradient = false, conservative_only = false, has_low = false;
  MatrixKind matrix = MatrixKind::none;
  std::uint32_t without = 0;
  double time = 0, cu = 1, cv = 0, ca = 0;
};

template <class T>
std::span<const std::byte> bytes_of(const T& plain) {
  return std::as_bytes(std::span(&plain, 1));
}
template <class T>
std::span<std::byte> writable_bytes_of(T& plain) {
  return std::as_writable_bytes(std::span(&plain, 1));
}

inline std::span<const double> part_of(std::span<const double> all, const Range& range) {
  return all.subspan(range.begin, range.size());
}

}  // namespace netloft
