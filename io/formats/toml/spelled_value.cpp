// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/spelled_value.hpp"

#include "io/formats/units/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace netloft::formats {

namespace {

/// Writes a text as a basic string of TOML.
std::string quote(std::string_view text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    if (byte >= 0x20 && byte != 0x7F)
      quoted += c;
    else
      (quoted += "\\u00") += {kHex[byte >> 4], kHex[byte & 15]};
  }
  return quoted + '"';
}

/// Whether a text can be written without quotes and is still read as a text: a quantity with a unit, or a
/// word.
bool is_plain(const std::string& text) {
  constexpr std::array<std::string_view, 4> kValues = {"true", "false", "inf", "nan"};
  const auto is_of_words = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '/' || c == '.';
  };
  if (const WrittenQuantity quantity = read_as_written(text); quantity.ok()) return !quantity.unit.empty();
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9') && text[0] != '-' &&
         std::all_of(text.begin(), text.end(), is_of_words) &&
         std::find(kValues.begin(), kValues.end(), text) == kValues.end();
}

template <class Items, class Spell>
std::string bracketed(const Items& items, const char* brackets, const Spell& spell) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + spell(item);
  return brackets[0] + text + brackets[1];
}

std::string spell_real(double real) {
  const std::string text = format(real);
  const bool is_real = !std::isfinite(real) || text.find_first_of(".e") != std::string::npos;
  return is_real ? text : text + ".0";
}

}  // namespace

std::string spell_value(const Value& value) {
  switch (value.kind()) {
    case Kind::table:
      return bracketed(value.as<Table>()->members, "{}",
                       [](const Member& m) { return spell_key(m.key) + " = " + spell_in_file(m.value); });
    case Kind::array:
      return bracketed(value.as<Array>()->items, "[]", spell_in_file);
    case Kind::text: {
      const std::string& text = *value.as<std::string>();
      return is_plain(text) ? text : quote(text);
    }
    case Kind::integer:
      return std::to_string(*value.as<std::int64_t>());
    case Kind::real:
      return spell_real(*value.as<double>());
    case Kind::boolean:
      return *value.as<bool>() ? "true" : "false";
    case Kind::date:
      return value.as<Date>()->text;
  }
  return {};
}

std::string spell_in_file(const Value& value) {
  const auto* text = value.as<std::string>();
  return text ? quote(*text) : spell_value(value);
}

}  // namespace netloft::formats
