// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"

#include <map>
#include <string>

namespace netloft::formats {

/// Properties of a number that its reader knows.
struct NumberWords {
  std::string unit;  // unit of the range
  std::string doc;   // half a sentence: "stretched mesh size"
  Range range;
  bool is_whole = false;
};

/// Collects, by path, the properties of all numbers that this thread reads while the object exists. Numbers
/// of parts that are taken from memory are not read again, and therefore not collected.
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

/// Gives the properties of a number to the collector of this thread, if there is one.
void collect_words(const std::string& path, const NumberWords& words);
/// Whether this thread has a collector.
bool are_words_collected();

}  // namespace netloft::formats
