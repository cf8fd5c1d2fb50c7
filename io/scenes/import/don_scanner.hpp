// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace netloft::scenes::femnet {

/// Reads the text of a .don, a gear file of FEMNET, as FEMNET does. In the first part of the file every value
/// follows a colon, and the words before the colons do not matter; the second part, the tail, consists of
/// words. After an error in the first part, the scanner stops, because it would read all later values from
/// wrong positions.
class DonScanner {
 public:
  DonScanner(std::string text, int file, formats::Diagnostics& diagnostics);

  bool has_failed() const { return has_failed_; }
  /// Moves to the position after the next colon. `what` names the expected value in errors.
  bool skip_colon(const char* what);
  /// The number after the next colon. If none follows, returns 0 with a warning.
  double real(const char* what);
  int integer(const char* what);
  /// The number after the next colon, which says how many values follow. It is required, and at least 0.
  int count(const char* what);
  /// A required number at this place, in a row or as argument of a keyword.
  double next_real(const char* what);
  int next_integer(const char* what);
  /// The number at this place. If there is none, returns nullopt, and skips blanks only.
  std::optional<double> try_real(bool whole = false);
  /// The text between two # signs after the next colon.
  std::string text_in_hashes(const char* what);
  /// Moves to the end of the line that contains the next word.
  void skip_worded_line();
  /// Returns the last word before the next colon, and moves to the position after this colon. If something
  /// else than words follows, returns nullopt and does not move.
  std::optional<std::string> word_before_colon();
  /// If the next word begins with this letter, moves to the position after the word. Returns whether it
  /// moved.
  bool try_word(char first_letter);

  /// The next word of the tail; an empty text at the end of the file.
  std::string_view word();
  /// Whether exactly one blank or end of line follows before the next word.
  bool has_one_separator() const;

  /// A position in the text, to which go_back() returns.
  struct Mark {
    std::size_t at;
    int line, column;
  };
  Mark mark() const { return {at_, line_, column_}; }
  void go_back(const Mark& to) {
    at_ = to.at;
    line_ = to.line;
    column_ = to.column;
  }

  formats::Place place() const;  // place of the next character
  formats::Place place_of_word() const { return word_place_; }
  void fail(const formats::Place& place, const std::string& message, const std::string& hint = {});

 private:
  void step();
  void skip_blanks();
  char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool is_at_end() const { return at_ >= text_.size(); }
  bool begins_a_number() const;
  std::optional<std::string> take_number(bool whole);
  void warn_of_tail();

  std::string text_;
  std::size_t at_ = 0;
  int file_, line_ = 1, column_ = 1;
  formats::Place word_place_;
  formats::Diagnostics& diagnostics_;
  bool has_failed_ = false;
};

}  // namespace netloft::scenes::femnet
