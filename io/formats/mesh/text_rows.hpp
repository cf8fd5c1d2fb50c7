// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::formats {

/// A word of a text with its place.
struct Word {
  std::string_view text;
  Place place;
};

/// A number in any notation that programs write: 1, 1.5, .5, 3., 1e-3, 1.D-3. nullopt for hexadecimal
/// numbers, infinity, NaN and other texts.
std::optional<double> number_in(std::string_view text);
std::optional<std::int64_t> integer_in(std::string_view text);

/// Splits a text into lines and lines into words. Lines end with LF, CR LF or CR.
class TextRows {
 public:
  /// `text` must outlive this object. Text after the character `comment` on a line is skipped; 0: no
  /// comments.
  TextRows(std::string_view text, int file, char comment = 0) : text_(text), file_(file), comment_(comment) {}

  /// The next line without its line break; nullopt at the end of the text.
  std::optional<std::string_view> next_line();
  /// The words of the next line that is not blank; empty at the end of the text.
  std::vector<Word> next_row();
  /// The number of the line that was read last; place() is its beginning.
  int line() const { return line_; }
  Place place() const { return {file_, line_, 1, 1}; }
  bool at_end() const { return at_ >= text_.size(); }

 private:
  std::vector<Word> words_of(std::string_view line) const;

  std::string_view text_;
  std::size_t at_ = 0;
  int file_, line_ = 0;
  char comment_;
};

}  // namespace netloft::formats
