// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace netloft::scenes {

/// A cell of a table of comma-separated values, without its surrounding quotes and blanks.
struct CsvCell {
  std::string text;
  formats::Place place;
};

/// Splits a text into rows and cells (RFC 4180). Cells that contain a separator, a quote or a line end are in
/// quotes, and a quote within such a cell is doubled. Lines end with LF, CR LF or CR.
class CsvRows {
 public:
  /// `text` must outlive this object. The separator of cells is whichever of comma, semicolon and tab comes
  /// first in the text.
  CsvRows(std::string_view text, int file);

  /// The next row that is not blank; an empty list at the end of the text. Lines that begin with # are
  /// skipped.
  std::vector<CsvCell> next();
  formats::Place place() const { return {file_, line_, 1, 1}; }
  /// Whether the text ended within quotes.
  bool ended_in_quotes() const { return ended_in_quotes_; }

 private:
  char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool is_at_end() const { return at_ >= text_.size(); }
  bool is_at_line_end() const { return is_at_end() || here() == '\n' || here() == '\r'; }
  void step();
  void skip_line_end();
  CsvCell take_cell();
  void take_quoted(std::string& text);

  std::string_view text_;
  std::size_t at_ = 0;
  int file_, line_ = 1, column_ = 1;
  char separator_ = ',';
  bool ended_in_quotes_ = false;
};

}  // namespace netloft::scenes
