// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace netloft::scenes::femnet {

/// Goes through the text of a .don as FEMNET does: its first part is values behind colons, whatever the words
/// before them; its second is words. After the first error of the first part it reads nothing more, because
/// all that follows would be read at the wrong place.
class DonScanner {
 public:
  DonScanner(std::string text, int file, formats::Diagnostics& diagnostics);

  bool has_failed() const { return has_failed_; }
  /// Goes behind the next colon. `what` is expected there, for errors.
  bool skip_colon(const char* what);
  /// A number behind the next colon. If there is none, it is 0, which is said.
  double real(const char* what);
  int integer(const char* what);
  /// The same of what decides how much follows: it must be there, and be 0 or more.
  int count(const char* what);
  /// A number at this place, one of a row or the arguments of a keyword. It must be there.
  double next_real(const char* what);
  int next_integer(const char* what);
  /// A number at this place, if there is one; else nothing is read but blanks.
  std::optional<double> try_real(bool whole = false);
  /// The text between the next two #, behind the next colon.
  std::string text_in_hashes(const char* what);
  /// Goes to the end of the line on which the next word stands.
  void skip_worded_line();
  /// The last word before the next colon, which is passed; nothing is passed if another kind of word follows.
  std::optional<std::string> word_before_colon();
  /// The next word, if it begins with this letter; else nothing is read.
  bool try_word(char first_letter);

  /// The next word of the tail; empty at the end.
  std::string_view word();
  /// Whether exactly one blank or end of line stands here, and then a word.
  bool has_one_separator() const;

  /// A place to return to.
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

  formats::Place place() const;  // here
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
