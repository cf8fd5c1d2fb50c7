// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::scenes {

/// Replaces every byte that is not ASCII by a question mark, because its encoding is unknown.
std::string in_ascii(const std::string& text);

/// Returns the text in quotes; it must not contain quotes.
std::string quoted(const std::string& text);
/// Returns an array of texts: ["a", "b"].
std::string quoted_list(const std::vector<std::string>& texts);

/// An inline table of TOML with the pairs that were added: { a = 1, b = 2 }.
class InlineTable {
 public:
  InlineTable& add(const char* key, double value);
  InlineTable& add_unless_zero(const char* key, double value) { return value == 0 ? *this : add(key, value); }
  InlineTable& add(const char* key, const std::string& value);
  std::string text() const { return "{" + text_ + " }"; }

 private:
  std::string text_;
};

/// The text of a scene, to which tables are appended in the order of the calls.
class SceneText {
 public:
  void begin_part(const std::string& name, const std::string& type, const std::string& comment = {});
  void line(const std::string& key, const std::string& value) { text_ += key + " = " + value + "\n"; }
  void line(const std::string& key, double value);
  void comment(const std::string& text) { text_ += "# " + text + "\n"; }
  /// Writes a hold; `axes` is "xyz" for all axes.
  void hold(const std::string& on, const std::string& name, const std::string& axes);
  void add(const std::string& text) { text_ += text; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace netloft::scenes
