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
  const char* key;  // key of a scene's part that takes it: a chain is given under `rope`; empty: none
  const char* doc;
  std::vector<PartKey> numbers;
  std::vector<const char*> texts = {};   // required ones besides source and uncertainty
  std::vector<const char*> tables = {};  // values handed on as they are written: curves
  std::vector<const char*> beside = {};  // the same, beside `key` in the table of the scene part
};

std::span<const PartKind> part_kinds();
/// Null if there is no such kind.
const PartKind* find_kind(std::string_view name);
/// Names of the kinds that a scene may give under `key`: "rope" → rope, wire, chain.
std::vector<std::string> kinds_under(std::string_view key);
/// Every `key` once: twine, rope, float.
std::vector<std::string> part_keys();

}  // namespace netloft::gears
