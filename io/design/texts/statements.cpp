// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/statements.hpp"

#include "io/design/texts/literal.hpp"

#include <algorithm>
#include <cassert>
#include <map>

namespace netloft::design {

namespace {

using Steps = std::vector<formats::PathStep>;

std::size_t end_of_line_after(const std::string& text, std::size_t at) {
  return std::min(text.find('\n', at), text.size() - 1) + 1;
}

/// The keys of "panels.bag" or "panels.\"top bag\"", also those that no change may name, such as include.
Steps keys_in(const std::string& text) {
  Steps steps = formats::read_change("table." + text + "=0").steps;
  if (!steps.empty()) steps.erase(steps.begin());
  return steps;
}

/// The position of a character outside of quotes.
std::size_t find_unquoted(const std::string& text, char wanted, std::size_t at) {
  while (at < text.size() && text[at] != wanted)
    at += text[at] == '"' || text[at] == '\'' ? length_of_literal(text, at) : 1;
  return at;
}

/// Reads the statements of a text from its beginning to its end.
class StatementReader {
 public:
  explicit StatementReader(const std::string& text) : text_(text) {}

  std::vector<Statement> all() {
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t first = text_.find_first_not_of(" \t\r", at);
      const bool is_empty = first == std::string::npos || text_[first] == '\n' || text_[first] == '#';
      at = is_empty ? end_of_line_after(text_, at) : read(at, first);
    }
    return std::move(statements_);
  }

 private:
  /// Reads the statement whose line begins at `begin`; returns the beginning of the line after it.
  std::size_t read(std::size_t begin, std::size_t first) {
    if (text_[first] == '[') return read_header(begin, first);
    const std::size_t equals = find_unquoted(text_, '=', first);
    const std::size_t value = std::min(text_.find_first_not_of(" \t", equals + 1), text_.size());
    Statement one{begin, end_of_line_after(text_, value + length_of_literal(text_, value)), value, table_};
    for (formats::PathStep& step : keys_in(text_.substr(first, equals - first)))
      one.path.push_back(std::move(step));
    assert(!one.path.empty());  // the text is valid
    statements_.push_back(std::move(one));
    return statements_.back().end;
  }

  std::size_t read_header(std::size_t begin, std::size_t first) {
    const bool is_item = text_[first + 1] == '[';
    const std::size_t name = first + (is_item ? 2 : 1), close = find_unquoted(text_, ']', name);
    table_.clear();
    const Steps keys = keys_in(text_.substr(name, close - name));
    std::string spelled;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      table_.push_back(keys[i]);
      spelled = formats::join_path(spelled, keys[i].key);
      const bool is_new = is_item && i + 1 == keys.size();
      if (is_new) ++counts_[spelled];
      if (const auto items = counts_.find(spelled); items != counts_.end())
        table_.push_back({{}, items->second - 1});
    }
    const std::size_t end = end_of_line_after(text_, close);
    statements_.push_back({begin, end, end, table_});
    return end;
  }

  const std::string& text_;
  Steps table_;                                // of the last header
  std::map<std::string, std::size_t> counts_;  // of the items of each array of tables
  std::vector<Statement> statements_;
};

/// The first byte of the comments directly above a line.
std::size_t begin_with_comments(const std::string& text, std::size_t begin) {
  while (begin > 0) {
    const std::size_t line = begin < 2 ? 0 : text.rfind('\n', begin - 2) + 1;
    if (text[line] != '#') break;
    begin = line;
  }
  return begin;
}

}  // namespace

std::vector<Statement> statements_of(const std::string& text) { return StatementReader(text).all(); }

bool is_within(std::span<const formats::PathStep> path, std::span<const formats::PathStep> outer) {
  return path.size() >= outer.size() && std::ranges::equal(path.first(outer.size()), outer);
}

std::string without_statements(const std::string& text, std::span<const formats::PathStep> path) {
  std::string left;
  std::size_t kept = 0;
  const auto keep = [&](std::size_t to) {
    const bool is_second_blank = left.ends_with("\n\n") && kept < to && text[kept] == '\n';
    left += text.substr(kept + is_second_blank, to - kept - is_second_blank);
  };
  for (const Statement& one : statements_of(text)) {
    if (!is_within(one.path, path)) continue;
    // A comment at the head of a file is about the file.
    const std::size_t begin = begin_with_comments(text, one.begin);
    keep(std::max(begin == 0 ? one.begin : begin, kept));
    kept = one.end;
  }
  keep(text.size());
  return left;
}

}  // namespace netloft::design
