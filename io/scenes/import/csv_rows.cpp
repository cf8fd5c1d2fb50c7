// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/csv_rows.hpp"

#include <algorithm>

namespace netloft::scenes {

CsvRows::CsvRows(std::string_view text, int file) : text_(text), file_(file) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // byte order mark of UTF-8
  for (std::size_t line = 0; line < text_.size();) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", line), text_.size());
    const auto separator = text_.substr(line, end - line).find_first_of(",;\t");
    if (text_[line] != '#' && separator != std::string_view::npos) {
      separator_ = text_[line + separator];
      return;
    }
    line = end + 1;
  }
}

std::vector<CsvCell> CsvRows::next() {
  while (!is_at_end()) {
    std::vector<CsvCell> row;
    const bool is_comment = here() == '#';
    while (is_comment && !is_at_line_end()) step();
    while (!is_comment && !is_at_line_end()) {
      row.push_back(take_cell());
      if (here() != separator_) break;
      step();
      if (is_at_line_end()) row.push_back({"", {file_, line_, column_, 1}});
    }
    skip_line_end();
    if (std::any_of(row.begin(), row.end(), [](const CsvCell& c) { return !c.text.empty(); })) return row;
  }
  return {};
}

CsvCell CsvRows::take_cell() {
  while (here() == ' ' || (here() == '\t' && separator_ != '\t')) step();
  CsvCell cell{"", {file_, line_, column_, 1}};
  if (here() == '"') take_quoted(cell.text);
  while (!is_at_line_end() && here() != separator_) {
    cell.text += here();
    step();
  }
  while (!cell.text.empty() && (cell.text.back() == ' ' || cell.text.back() == '\t')) cell.text.pop_back();
  if (line_ == cell.place.line) cell.place.length = std::max(1, column_ - cell.place.column);
  return cell;
}

void CsvRows::take_quoted(std::string& text) {
  step();
  while (!is_at_end() && (here() != '"' || here(1) == '"')) {
    if (here() == '"') step();
    text += here();
    is_at_line_end() ? skip_line_end() : step();
  }
  ended_in_quotes_ = ended_in_quotes_ || is_at_end();
  if (!is_at_end()) step();
}

void CsvRows::step() {
  if ((here() & 0xC0) != 0x80) ++column_;
  ++at_;
}

void CsvRows::skip_line_end() {
  if (is_at_end()) return;
  at_ += here() == '\r' && here(1) == '\n' ? 2 : 1;
  ++line_;
  column_ = 1;
}

}  // namespace netloft::scenes
