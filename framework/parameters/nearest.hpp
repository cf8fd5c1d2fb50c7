// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace netloft {
namespace detail {

inline char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Damerau-Levenshtein distance (optimal string alignment): the number of letters that must be inserted,
/// removed, replaced or swapped with the next letter. Letter case is ignored. d(i,j) is the distance of the
/// first i letters of a and the first j of b:
///   d(i,j) = min( d(i-1,j)+1, d(i,j-1)+1, d(i-1,j-1)+[aᵢ≠bⱼ], d(i-2,j-2)+1 if aᵢaᵢ₋₁ = bⱼ₋₁bⱼ )   (1)
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);  // (1)
    }
  }
  return row[b.size()];
}

}  // namespace detail

/// The candidate that `word` most likely means. At most a third of the letters of `word` may be wrong, or one
/// letter in a short word. Returns nullopt if no candidate is similar, and the first one if several are
/// equally similar.
inline std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t kLongestWord = 64;  // bounds the work for meaningless input
  if (word.empty() || word.size() > kLongestWord) return std::nullopt;
  std::size_t limit = std::min(std::max<std::size_t>(1, word.size() / 3), word.size() - 1);
  const std::string* best = nullptr;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > word.size() + limit) continue;
    const std::size_t distance = detail::edit_distance(word, candidate);
    if (distance > limit || (best && distance == limit)) continue;
    best = &candidate;
    limit = distance;
  }
  return best ? std::optional<std::string>(*best) : std::nullopt;
}

}  // namespace netloft
