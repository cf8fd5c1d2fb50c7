// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::gears {

/// A number in the catalogue entry of a part.
struct PartKey {
  const char* name;
  const char* unit;
  const char* doc;
  double lo, hi;
  bool required = false;
};

/// A kind of catalogue entries: `[twine.NAME]`, `[chain.NAME]`, …
struct PartKind {
  const char* name;
  const char* key;  // key in the part of a scene: `rope` for a chain; empty: none
  const char* doc;
  std::vector<PartKey> numbers;
  std::vector<const char*> texts = {};   // required texts besides source and uncertainty
  std::vector<const char*> tables = {};  // tables of curves, which are passed on unchanged
  std::vector<const char*> beside = {};  // tables copied unchanged next to `key` in the part of a scene
};

std::span<const PartKind> part_kinds();
const PartKind* find_kind(std::string_view name);
/// Names of the kinds that a scene may give under `key`: "rope" → rope, wire, chain.
std::vector<std::string> kinds_under(std::string_view key);
/// All keys under which a scene may name catalogue parts, each once: twine, rope, float, board.
std::vector<std::string> part_keys();

}  // namespace netloft::gears
