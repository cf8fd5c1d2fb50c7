// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/scene_text.hpp"

#include "io/formats/mesh/mesh.hpp"

namespace netloft::scenes {

std::string in_ascii(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c < 0 || c >= 0x20)
      out += c < 0 || c == 0x7F ? '?' : c;
    else
      out += ' ';
  return out;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string quoted_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const auto& text : texts) list += (list.empty() ? "" : ", ") + quoted(text);
  return "[" + list + "]";
}

InlineTable& InlineTable::add(const char* key, double value) {
  return add(key, formats::spell_number(value));
}

InlineTable& InlineTable::add(const char* key, const std::string& value) {
  text_ += (text_.empty() ? " " : ", ") + std::string(key) + " = " + value;
  return *this;
}

void SceneText::begin_part(const std::string& name, const std::string& type, const std::string& comment) {
  text_ += "\n[parts." + name + "]" + (comment.empty() ? "" : "  # " + comment) + "\n";
  line("type", quoted(type));
}

void SceneText::line(const std::string& key, double value) { line(key, formats::spell_number(value)); }

void SceneText::hold(const std::string& on, const std::string& name, const std::string& axes) {
  text_ += "\n[[hold]]\n";
  line("on", quoted(on));
  line("name", quoted(name));
  if (axes != "xyz") line("axes", quoted(axes));
}

}  // namespace netloft::scenes
