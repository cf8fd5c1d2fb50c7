// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/number_words.hpp"

namespace netloft::formats {

namespace {

thread_local CollectedWords* collector = nullptr;

}  // namespace

CollectedWords::CollectedWords() : before_(collector) { collector = this; }

CollectedWords::~CollectedWords() { collector = before_; }

bool are_words_collected() { return collector; }

void collect_words(const std::string& path, const NumberWords& words) {
  if (collector) collector->by_path[path] = words;
}

}  // namespace netloft::formats
