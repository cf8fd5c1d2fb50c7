// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/element_memory.hpp"

#include "framework/assembler/tile_evaluator.hpp"

#include <algorithm>
#include <cassert>

namespace netloft {

namespace {

bool remembers(const ElementFamily& family, bool ground_passes) {
  return std::ranges::any_of(family.active_terms(), [&](const netloft_term& term) {
    return term.traits & NETLOFT_READS_STATE && !(ground_passes && term.traits & NETLOFT_READS_GROUND);
  });
}

/// Calls the terms of a family (all elements of one type) that have a memory, so that they write the next
/// state of the elements.
bool remember_family(TileEvaluator& elements, std::size_t family, std::span<const double> x,
                     const Kinematics& motion) {
  const ElementFamily& f = *elements.tiles().families[family];
  Memory& memory = elements.memories()[family];
  memory.begin();
  const auto evaluate = [&](std::size_t tile, netloft_tile& t, TileSums&) {
    elements.take_next_state(memory.next(tile));
    for (const auto& term : f.active_terms())
      if (term.traits & NETLOFT_READS_STATE)
        if (const int status = f.evaluate(term, t); status != NETLOFT_OK) return status;
    return int{NETLOFT_OK};
  };
  return elements.visit(x, motion, family, evaluate,
                        [](std::size_t, const netloft_tile&, const TileSums&) {});
}

}  // namespace

std::vector<Memory> make_memories(const ElementTiles& tiles, bool ground_passes) {
  std::vector<Memory> memories;
  for (std::size_t f = 0; f < tiles.families.size(); ++f) {
    const ElementFamily& family = *tiles.families[f];
    memories.emplace_back(tiles.group_of(f).tiling.tiles,
                          remembers(family, ground_passes) ? family.type().state_width : 0);
  }
  return memories;
}

bool remember(TileEvaluator& elements, std::span<const double> x, const Kinematics& motion) {
  auto& memories = elements.memories();
  for (std::size_t f = 0; f < memories.size(); ++f)
    if (!memories[f].empty() && !remember_family(elements, f, x, motion)) return false;
  for (Memory& memory : memories) memory.accept();
  return true;
}

std::vector<double> read_memory(TileEvaluator& elements) {
  std::vector<double> numbers;
  for (const auto* memories : {&elements.memories(), &elements.mean_forces().rates()})
    for (const Memory& memory : *memories)
      numbers.insert(numbers.end(), memory.all().begin(), memory.all().end());
  return numbers;
}

void write_memory(TileEvaluator& elements, std::span<const double> numbers) {
  for (auto* memories : {&elements.memories(), &elements.mean_forces().rates()})
    for (Memory& memory : *memories) {
      assert(numbers.size() >= memory.all().size());
      std::copy_n(numbers.begin(), memory.all().size(), memory.all().begin());
      numbers = numbers.subspan(memory.all().size());
    }
  assert(numbers.empty() && "the memory belongs to a scene with as many elements");
}

}  // namespace netloft
