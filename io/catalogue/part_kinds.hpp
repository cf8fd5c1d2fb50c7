// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::io {

/// One number that a catalogue says of a part.
struct PartKey {
  const char* name;
  const char* unit;
  const char* doc;
  double lo, hi;
  bool required = false;
};

/// What a catalogue may hold: `[twine.NAME]`, `[chain.NAME]`, …
struct PartKind {
  const char* name;
  const char* key;  // of a scene's part that takes it: a chain stands under `rope`; empty: none
  const char* doc;
  std::vector<PartKey> numbers;
  std::vector<const char*> texts = {};  // required ones, beside source and uncertainty
};

std::span<const PartKind> part_kinds();
/// Null: there is no such kind.
const PartKind* find_kind(std::string_view name);
/// Names of the kinds that may stand under `key`: "rope" → rope, wire, chain.
std::vector<std::string> kinds_under(std::string_view key);
/// Every `key` once: twine, rope, float.
std::vector<std::string> part_keys();

}  // namespace netloft::io
