// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"

#include <map>
#include <string>

namespace netloft::formats {

/// Facts that the reader of a number knows of it.
struct NumberWords {
  std::string unit;  // unit of the range
  std::string doc;   // half a sentence: "stretched mesh size"
  Range range;
  bool is_whole = false;
};

/// Keeps what readers know of the numbers that this thread reads, by their paths, while it exists. A number
/// that is found in a stored result is not read again.
class CollectedWords {
 public:
  CollectedWords();
  ~CollectedWords();
  CollectedWords(const CollectedWords&) = delete;
  CollectedWords& operator=(const CollectedWords&) = delete;

  std::map<std::string, NumberWords> by_path;

 private:
  CollectedWords* before_;
};

/// Hands the words of a number to the collector of this thread, if there is one.
void collect_words(const std::string& path, const NumberWords& words);
/// Whether there is one.
bool are_words_collected();

}  // namespace netloft::formats
