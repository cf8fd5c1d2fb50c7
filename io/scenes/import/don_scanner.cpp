// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/don_scanner.hpp"

#include "io/formats/mesh/text_rows.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace netloft::scenes::femnet {

namespace {

constexpr int kMostCounted = 10000000;
constexpr std::size_t kLongestText = 200;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\v' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The text with LF at the end of every line, and without a byte order mark.
std::string with_plain_ends(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '\r')
      out += text[i];
    else if (i + 1 >= text.size() || text[i + 1] != '\n')
      out += '\n';
  if (out.starts_with("\xEF\xBB\xBF")) out.erase(0, 3);  // byte order mark of UTF-8
  return out;
}

}  // namespace

DonScanner::DonScanner(std::string text, int file, formats::Diagnostics& diagnostics)
    : text_(with_plain_ends(text)), file_(file), diagnostics_(diagnostics) {}

formats::Place DonScanner::place() const { return {file_, line_, column_, 1}; }

void DonScanner::fail(const formats::Place& place, const std::string& message, const std::string& hint) {
  if (!has_failed_) diagnostics_.error(place, message, hint);
  has_failed_ = true;
}

void DonScanner::step() {
  if (here() == '\n') {
    ++line_;
    column_ = 1;
  } else if ((here() & 0xC0) != 0x80)
    ++column_;
  ++at_;
}

void DonScanner::skip_blanks() {
  while (!is_at_end() && is_blank(here())) step();
}

bool DonScanner::skip_colon(const char* what) {
  if (has_failed_) return false;
  while (!is_at_end() && here() != ':') step();
  if (is_at_end()) fail(place(), std::string("the file ends where ") + what + " is expected");
  if (!has_failed_) step();
  return !has_failed_;
}

bool DonScanner::begins_a_number() const {
  const std::size_t sign = here() == '+' || here() == '-' ? 1 : 0, point = here(sign) == '.' ? 1 : 0;
  return is_digit(here(sign + point));
}

/// Reads the characters of a number; if `whole`, only a sign and digits. Returns nullopt if no number begins
/// here.
std::optional<std::string> DonScanner::take_number(bool whole) {
  if (!begins_a_number() || (whole && !is_digit(here(here() == '+' || here() == '-' ? 1 : 0)))) return {};
  std::string digits;
  const auto take = [&] {
    digits += here();
    step();
  };
  const auto take_digits = [&] {
    while (is_digit(here())) take();
  };
  if (here() == '+' || here() == '-') take();
  take_digits();
  if (whole) return digits;
  if (here() == '.') take();
  take_digits();
  const char e = here();
  const std::size_t sign = here(1) == '+' || here(1) == '-' ? 1 : 0;
  if ((e == 'e' || e == 'E' || e == 'd' || e == 'D') && is_digit(here(1 + sign))) {
    digits += 'e';
    step();
    if (sign) take();
    take_digits();
  }
  return digits;
}

void DonScanner::warn_of_tail() {
  if (here() == ',' && is_digit(here(1)))
    diagnostics_.warning(place(), "a comma is no decimal point here: the digits behind it are not read",
                         "write a point");
  if (here() == 'x' || here() == 'X') fail(place(), "hexadecimal numbers are not read");
}

std::optional<double> DonScanner::try_real(bool whole) {
  if (has_failed_) return {};
  skip_blanks();
  const formats::Place begun = place();
  const auto digits = take_number(whole);
  if (!digits) {
    std::string word;
    for (std::size_t i = here() == '-' || here() == '+' ? 1 : 0; i < 10 && is_letter(here(i)); ++i)
      word += static_cast<char>(std::tolower(here(i)));
    if (word == "nan" || word == "inf" || word == "infinity")
      fail(begun, "a number is expected, and \"" + word + "\" is none");
    return {};
  }
  warn_of_tail();
  const auto value = formats::number_in(*digits);
  if (!value) fail(begun, "the number " + digits->substr(0, 40) + " is too large");
  return value;
}

double DonScanner::real(const char* what) {
  if (!skip_colon(what)) return 0;
  const formats::Place begun = place();
  const auto value = try_real();
  if (!value && !has_failed_) diagnostics_.warning(begun, std::string(what) + " is blank, and taken as 0");
  return value.value_or(0);
}

int DonScanner::integer(const char* what) {
  if (!skip_colon(what)) return 0;
  const formats::Place begun = place();
  const auto value = try_real(true);
  if (!value && !has_failed_) diagnostics_.warning(begun, std::string(what) + " is blank, and taken as 0");
  return value && std::abs(*value) <= kMostCounted ? static_cast<int>(*value) : 0;
}

int DonScanner::count(const char* what) {
  if (!skip_colon(what)) return 0;
  const formats::Place begun = place();
  const auto value = try_real(true);
  if (!value)
    fail(begun, std::string(what) + " is blank; a whole number is expected", "write 0 if there are none");
  else if (*value < 0 || *value > kMostCounted)
    fail(begun, std::string(what) + " is outside [0, " + std::to_string(kMostCounted) + "]");
  return has_failed_ ? 0 : static_cast<int>(*value);
}

double DonScanner::next_real(const char* what) {
  if (has_failed_) return 0;
  const auto value = try_real();
  if (!value) fail(place(), std::string("a number is expected here: ") + what);
  return value.value_or(0);
}

int DonScanner::next_integer(const char* what) {
  if (has_failed_) return 0;
  skip_blanks();
  const formats::Place begun = place();
  const auto value = try_real();
  if (!value || std::abs(*value) > kMostCounted)
    fail(begun, std::string("a whole number is expected here: ") + what);
  return has_failed_ ? 0 : static_cast<int>(*value);
}

std::string DonScanner::text_in_hashes(const char* what) {
  if (!skip_colon(what)) return {};
  while (!is_at_end() && here() != '#') step();
  while (here() == '#' || here() == ' ' || here() == '\t') step();
  const std::size_t end = text_.find('#', at_), line_end = std::min(text_.find('\n', at_), text_.size());
  if (end == std::string::npos || end > std::max(line_end, at_ + kLongestText)) return {};
  std::string text = text_.substr(at_, end - at_);
  while (at_ <= end) step();
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  return text;
}

void DonScanner::skip_worded_line() {
  if (has_failed_) return;
  skip_blanks();
  while (!is_at_end() && here() != '\n') step();
  if (!is_at_end()) step();
}

std::optional<std::string> DonScanner::word_before_colon() {
  if (has_failed_) return {};
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && is_letter(text_[end])) ++end;
  std::size_t colon = end;
  while (colon < text_.size() && is_blank(text_[colon])) ++colon;
  if (end == at_ || colon >= text_.size() || text_[colon] != ':') return {};
  const std::string word = text_.substr(at_, end - at_);
  while (at_ <= colon) step();
  return word;
}

bool DonScanner::try_word(char first_letter) {
  if (has_failed_) return false;
  skip_blanks();
  if (here() != first_letter) return false;
  while (!is_at_end() && !is_blank(here())) step();
  return true;
}

std::string_view DonScanner::word() {
  skip_blanks();
  const std::size_t begin = at_;
  word_place_ = place();
  while (!is_at_end() && !is_blank(here())) step();
  word_place_.length = std::max(column_ - word_place_.column, 1);
  return std::string_view(text_).substr(begin, at_ - begin);
}

bool DonScanner::has_one_separator() const { return is_blank(here()) && here(1) && !is_blank(here(1)); }

}  // namespace netloft::scenes::femnet
